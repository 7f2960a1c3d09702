#include "tlm/units/view_clip.h"

namespace repousse::shell {

ViewClip::ViewClip(const sc_core::sc_module_name& name, const Profile& profile)
    : Place(name), unit_(profile) {}

void ViewClip::process(BaseBatch& batch, BatchTime& time) {
    for (BaseItem& item : batch.items) {
        const auto& [a, b, c] = item.corners;
        item.rejected = unit_({a->eye, b->eye, c->eye}, item.max_displacement);
    }
    time.stage(kViewClipDesc, batch.items.size());
}

}  // namespace repousse::shell
