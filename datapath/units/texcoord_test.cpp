#include "datapath/units/texcoord_test.h"

namespace repousse {

TexcoordTest::TexcoordTest(const Profile& profile) : frac_(profile.uv.frac) {}

}  // namespace repousse
