#include "testbench/cosim/scoreboard.h"

#include <fmt/format.h>

#include <algorithm>

#include "testbench/cosim/parameters.h"

namespace repousse::cosim {

void Scoreboard::compare(const Scenario& scenario, uint64_t first,
                         const std::vector<int64_t>& engine, const std::vector<int64_t>& datapath,
                         const uint64_t* depart) {
    const std::size_t outputs = model_->outputs();
    const std::size_t count = model_->count(scenario);
    cases_ += count;
    if (std::equal(datapath.begin(), datapath.end(), engine.begin())) return;

    const std::vector<const Port*> ports = ports_of(model_->desc(), PortKind::Output);
    for (std::size_t i = 0; i < count; ++i) {
        std::size_t wrong = 0;
        while (wrong < outputs && engine[i * outputs + wrong] == datapath[i * outputs + wrong]) {
            ++wrong;
        }
        if (wrong == outputs) continue;
        ++mismatches_;
        if (first + i >= first_) continue;
        const Format format = port_format(*ports[wrong], model_->profile());
        const int64_t got = engine[i * outputs + wrong];
        const int64_t expected = datapath[i * outputs + wrong];
        const std::string cycle = depart == nullptr ? "" : fmt::format(", cycle {}", depart[i]);
        note(first + i,
             fmt::format("{}: transaction {} ({}, {}){}, field {}: engine {}, datapath {}, "
                         "error {:+} LSB; {}",
                         model_->desc().name, first + i, scenario.name, source_, cycle,
                         ports[wrong]->name, field_text(got, format), field_text(expected, format),
                         got - expected, describe(scenario, i)));
    }
}

void Scoreboard::broken(const Scenario& scenario, uint64_t first, const std::string& what) {
    cases_ += model_->count(scenario);
    ++mismatches_;
    note(first, fmt::format("{}: transactions from {} on ({}, {}): {}", model_->desc().name, first,
                            scenario.name, source_, what));
}

void Scoreboard::merge(const Scoreboard& other) {
    cases_ += other.cases_;
    mismatches_ += other.mismatches_;
    if (!other.text_.empty()) note(other.first_, other.text_);
}

std::string Scoreboard::describe(const Scenario& scenario, std::size_t index) const {
    std::string text = "with";
    const auto add = [&](PortKind kind, const int64_t* words) {
        for (const Port* port : ports_of(model_->desc(), kind)) {
            const Format format = port_format(*port, model_->profile());
            text += fmt::format(" {}={}", port->name, field_text(*words++, format));
        }
    };
    add(PortKind::Config, scenario.config.data());
    add(PortKind::Input, &scenario.inputs[index * model_->inputs()]);
    return text;
}

void Scoreboard::note(uint64_t transaction, std::string text) {
    if (transaction >= first_) return;
    first_ = transaction;
    text_ = std::move(text);
}

}  // namespace repousse::cosim
