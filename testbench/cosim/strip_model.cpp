#include "datapath/strip_ports.h"

#include <algorithm>

#include "testbench/cosim/strip_cases.h"
#include "testbench/cosim/unit_model.h"

namespace repousse::cosim {
namespace {

class StripModel : public UnitModel {
public:
    explicit StripModel(const Profile& profile)
        : UnitModel(profile, kStripDesc), unit_(static_cast<std::size_t>(profile.column_depth)) {}

    const UnitDesc& desc() const override { return kStripDesc; }
    std::vector<Scenario> hard_cases() const override { return strip_cases(profile()); }
    Scenario random(Random& random, std::size_t count) const override;

    /// The unit has a memory: there is no end of what could be tried.
    Scenario exhaustive(uint64_t) const override { return {}; }

    void evaluate(const Scenario& scenario, std::vector<int64_t>& outputs) override {
        answer_each(scenario, outputs, [this](const Word* words) {
            const StripIn in = StripIn::unpack(words);
            if (in.flush) unit_.flush();
            const uint64_t bad_before = unit_.counters().bad_refs;
            StripOut out;
            unit_(in.step, {in.vertices.data(), in.vertices.size()}, out.made);
            out.bad_ref = unit_.counters().bad_refs != bad_before;
            return out.pack();
        });
    }

    std::unique_ptr<UnitModel> with(const Profile& profile) const override {
        return make_strip_model(profile);
    }

    /// FIFOs of three: full and empty all the time.
    Profile tiny_profile() const override {
        Profile tiny = profile();
        tiny.column_depth = 3;
        return tiny;
    }

private:
    StripStep random_step(Random& random, bool orderly) const;

    Strip<uint32_t> unit_;
};

StripStep StripModel::random_step(Random& random, bool orderly) const {
    StripStep s;
    s.init = random.percent(15);
    s.flip = random.percent(50);
    s.count = static_cast<uint8_t>(random.below(5));
    for (StripCommand& command : s.commands) {
        command.op = static_cast<StripOp>(random.below(4));
        if (orderly && random.percent(60)) command.op = StripOp::New;
        command.place = static_cast<uint8_t>(random.below(4));
        command.keep = static_cast<StripKeep>(random.below(4));
        if (orderly && random.percent(50)) command.keep = StripKeep::No;
    }
    return s;
}

Scenario StripModel::random(Random& random, std::size_t count) const {
    std::vector<Scenario> cases;
    StripSteps to(profile(), cases, static_cast<uint32_t>(random.next()));
    to.begin("random");
    const bool swept = random.percent(50);
    const bool orderly = random.percent(50);
    const auto written = [&] { return cases.back().inputs.size() / inputs(); };
    while (written() < count) {
        if (!swept) {
            if (random.percent(1)) to.flush();
            to.step(random_step(random, orderly));
            continue;
        }
        const uint32_t size = 2 + random.below(random.percent(20) ? 60 : 14);
        GridCorners corners;
        for (auto& corner : corners) {
            for (int32_t& x : corner) x = static_cast<int32_t>(random.below(size));
        }
        const std::size_t left = count - written();
        const std::size_t limit = random.percent(5) ? random.below(20) : left;
        if (!to.sweep(corners, std::min(limit, left))) to.flush();
    }
    return cases.back();
}

}  // namespace

std::unique_ptr<UnitModel> make_strip_model(const Profile& profile) {
    return std::make_unique<StripModel>(profile);
}

}  // namespace repousse::cosim
