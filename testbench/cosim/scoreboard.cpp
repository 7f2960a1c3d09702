#include "testbench/cosim/scoreboard.h"

#include <fmt/format.h>

#include "testbench/cosim/parameters.h"

namespace repousse::cosim {

void Scoreboard::compare(const Scenario& scenario, uint64_t first,
                         const std::vector<int64_t>& engine, const std::vector<int64_t>& datapath,
                         const uint64_t* depart) {
    const std::size_t outputs = model_->outputs();
    cases_ += model_->count(scenario);
    if (datapath == engine) return;

    const std::vector<PortWord> ports =
        port_words(model_->desc(), PortKind::Output, model_->profile());
    uint64_t beat = 0;  // of the item
    bool counted = false;
    for (std::size_t i = 0, at = 0; at < datapath.size(); at += outputs, ++beat) {
        std::size_t wrong = 0;
        while (wrong < outputs && at + wrong < engine.size() &&
               engine[at + wrong] == datapath[at + wrong]) {
            ++wrong;
        }
        const bool ends = model_->ends_item(&datapath[at]);
        if (wrong != outputs) {
            mismatches_ += !counted;
            counted = true;
            if (first + i < first_ && at + wrong < engine.size()) {
                const Format& format = ports[wrong].format;
                const int64_t got = engine[at + wrong], expected = datapath[at + wrong];
                const std::string number = model_->last() < 0 ? "" : fmt::format(", beat {}", beat);
                const std::string cycle =
                    depart == nullptr ? "" : fmt::format(", cycle {}", depart[at / outputs]);
                note(first + i,
                     fmt::format("{}: transaction {}{} ({}, {}){}, field {}: engine {}, datapath "
                                 "{}, error {:+} LSB; {}",
                                 model_->desc().name, first + i, number, scenario.name, source_,
                                 cycle, ports[wrong].name, field_text(got, format),
                                 field_text(expected, format), got - expected,
                                 describe(scenario, i)));
            }
        }
        if (!ends) continue;
        ++i;
        beat = ~uint64_t{0};
        counted = false;
    }
}

void Scoreboard::broken(const Scenario& scenario, uint64_t first, const std::string& what) {
    ++mismatches_;
    note(first, fmt::format("{}: transactions from {} on ({}, {}): {}", model_->desc().name, first,
                            scenario.name, source_, what));
}

uint64_t Scoreboard::items_in(const std::vector<int64_t>& beats) const {
    uint64_t items = 0;
    for (std::size_t at = 0; at < beats.size(); at += model_->outputs()) {
        items += model_->ends_item(&beats[at]);
    }
    return items;
}

void Scoreboard::merge(const Scoreboard& other) {
    cases_ += other.cases_;
    mismatches_ += other.mismatches_;
    if (!other.text_.empty()) note(other.first_, other.text_);
}

std::string Scoreboard::describe(const Scenario& scenario, std::size_t index) const {
    std::string text = "with";
    const auto add = [&](PortKind kind, const int64_t* words) {
        for (const PortWord& port : port_words(model_->desc(), kind, model_->profile())) {
            text += fmt::format(" {}={}", port.name, field_text(*words++, port.format));
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
