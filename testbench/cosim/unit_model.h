#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "datapath/profile.h"
#include "datapath/transaction.h"
#include "datapath/unit_desc.h"
#include "testbench/cosim/engine.h"
#include "testbench/cosim/random.h"

namespace repousse::cosim {

/// Transactions under one setting of a unit's registers, and with one table behind its read port.
/// Words stand in the order of the description's ports.
struct Scenario {
    std::string name;
    std::vector<int64_t> config;
    std::shared_ptr<const Table> table;  ///< null for units without a read port
    std::vector<int64_t> inputs;         ///< count * number of Input ports

    template <class In>
    void add(const In& transaction) {
        for (const int64_t word : transaction.pack()) inputs.push_back(word);
    }
};

/// What co-simulation knows of a unit: its datapath as the judge, and what is worth trying.
class UnitModel {
public:
    virtual ~UnitModel() = default;

    virtual const UnitDesc& desc() const = 0;

    /// Whether the unit has a read port, so that its scenarios have a table.
    virtual bool reads_table() const { return false; }

    /// Bits of an entry of its table, at most 64: as vector files have it, or more than it needs.
    virtual int entry_bits() const { return profile_.sat_width; }

    /// Random transactions under one setting of the registers: long against any pipeline, small
    /// against a cache.
    virtual std::size_t batch() const { return 4096; }

    /// How much work a transaction is, in Verilator and in Icarus, against the decision on an edge:
    /// by default so many fewer are tried.
    virtual uint64_t weight() const { return 1; }
    virtual uint64_t icarus_weight() const { return 1; }

    /// The hard cases by name. They are the same in every run and are committed as vectors.
    virtual std::vector<Scenario> hard_cases() const = 0;

    /// `count` random transactions under random registers, most of them near a decision's border.
    virtual Scenario random(Random& random, std::size_t count) const = 0;

    /// Every transaction of a tiny profile, in portions: the one numbered `portion`, or an empty
    /// scenario behind the last one. Only for a model of tiny_profile().
    virtual Scenario exhaustive(uint64_t portion) const = 0;

    /// The datapath's outputs for a scenario, beat by beat, in order.
    virtual void evaluate(const Scenario& scenario, std::vector<int64_t>& outputs) = 0;

    /// A model of the same unit under another profile.
    virtual std::unique_ptr<UnitModel> with(const Profile& profile) const = 0;

    /// The profile under which exhaustive() is possible.
    virtual Profile tiny_profile() const = 0;

    const Profile& profile() const { return profile_; }
    /// Words of an item, words of a beat, and which of the latter marks an item's last beat (-1:
    /// each item is one beat).
    std::size_t inputs() const { return inputs_; }
    std::size_t outputs() const { return outputs_; }
    int last() const { return last_; }
    bool ends_item(const int64_t* beat) const { return last_ < 0 || beat[last_] != 0; }
    std::size_t count(const Scenario& scenario) const { return scenario.inputs.size() / inputs_; }

protected:
    UnitModel(const Profile& profile, const UnitDesc& desc);

    /// evaluate() of a unit that makes one beat of each item: `answer` turns a pointer to the
    /// item's words into the beat's.
    template <class Answer>
    void answer_each(const Scenario& scenario, std::vector<int64_t>& outputs,
                     const Answer& answer) const {
        outputs.clear();
        for (std::size_t i = 0; i < scenario.inputs.size(); i += inputs_) {
            for (const Word word : answer(&scenario.inputs[i])) outputs.push_back(word);
        }
    }

private:
    Profile profile_;
    std::size_t inputs_;
    std::size_t outputs_;
    int last_;
};

/// The names of the units that have RTL, and their models.
const std::vector<std::string_view>& rtl_units();
std::unique_ptr<UnitModel> make_unit_model(std::string_view name, const Profile& profile);

std::unique_ptr<UnitModel> make_texcoord_test_model(const Profile& profile);
std::unique_ptr<UnitModel> make_view_test_model(const Profile& profile);
std::unique_ptr<UnitModel> make_height_test_model(const Profile& profile);
std::unique_ptr<UnitModel> make_normal_test_model(const Profile& profile);
std::unique_ptr<UnitModel> make_edge_iter_model(const Profile& profile);
std::unique_ptr<UnitModel> make_mid_vertex_model(const Profile& profile);
std::unique_ptr<UnitModel> make_split_model(const Profile& profile);
std::unique_ptr<UnitModel> make_displace_model(const Profile& profile);
std::unique_ptr<UnitModel> make_bump_model(const Profile& profile);
std::unique_ptr<UnitModel> make_view_clip_model(const Profile& profile);
std::unique_ptr<UnitModel> make_perspective_model(const Profile& profile);
std::unique_ptr<UnitModel> make_footprint_model(const Profile& profile);
std::unique_ptr<UnitModel> make_normalise_model(const Profile& profile);
std::unique_ptr<UnitModel> make_grid_transform_model(const Profile& profile);
std::unique_ptr<UnitModel> make_strip_model(const Profile& profile);
std::unique_ptr<UnitModel> make_sweep_chain_model(const Profile& profile);
std::unique_ptr<UnitModel> make_sweep_line_model(const Profile& profile);
std::unique_ptr<UnitModel> make_shade_model(const Profile& profile);
std::unique_ptr<UnitModel> make_tessellation_tests_model(const Profile& profile);
std::unique_ptr<UnitModel> make_texel_cache_model(const Profile& profile);

}  // namespace repousse::cosim
