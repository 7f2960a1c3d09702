#include "testbench/cosim/unit_model.h"

#include "datapath/transaction.h"

namespace repousse::cosim {

UnitModel::UnitModel(const Profile& profile, const UnitDesc& desc)
    : profile_(profile),
      inputs_(port_count(desc, PortKind::Input)),
      outputs_(port_count(desc, PortKind::Output)) {}

const std::vector<std::string_view>& rtl_units() {
    static const std::vector<std::string_view> names = {"texcoord_test", "view_test",
                                                        "height_test"};
    return names;
}

std::unique_ptr<UnitModel> make_unit_model(std::string_view name, const Profile& profile) {
    if (name == "texcoord_test") return make_texcoord_test_model(profile);
    if (name == "view_test") return make_view_test_model(profile);
    if (name == "height_test") return make_height_test_model(profile);
    return nullptr;
}

}  // namespace repousse::cosim
