#include "testbench/cosim/session.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <iterator>
#include <mutex>
#include <thread>

#include "testbench/cosim/scoreboard.h"

namespace repousse::cosim {
namespace {

/// Gaps and stalls that between them have found every wrong latency, capacity and backward latency
/// that was tried (decisions/timing.md, section 4): {source, sink} percent and the burst length.
struct Stalls {
    uint32_t source, sink, burst;
};
constexpr Stalls kStalls[] = {{50, 100, 1}, {100, 50, 1}, {60, 70, 1}, {14, 23, 1},
                              {77, 40, 16}, {100, 12, 1}, {84, 86, 64}};

/// Feeds scenarios to one instance of an engine and to the datapath.
class Worker {
public:
    Worker(const UnitModel& model, const Engine& engine, const std::string& source)
        : model_(model.with(model.profile())), instance_(engine), scoreboard_(*model_, source) {}

    /// `first` numbers the transactions; `stalls` is null for a run at full speed.
    void run(const Scenario& scenario, uint64_t first, Random& random, const Stalls* stalls) {
        model_->evaluate(scenario, datapath_outputs_);
        stream(scenario, first, random, stalls);
    }

    /// Likewise, with the outputs that were recorded in the place of the datapath's.
    void run(const Recorded& recorded, uint64_t first, Random& random, const Stalls* stalls) {
        datapath_outputs_ = recorded.outputs;
        stream(recorded.scenario, first, random, stalls);
    }

    UnitModel& model() { return *model_; }
    const Scoreboard& scoreboard() const { return scoreboard_; }

private:
    void stream(const Scenario& scenario, uint64_t first, Random& random, const Stalls* stalls) {
        const std::size_t count = model_->count(scenario);
        engine_outputs_.assign(datapath_outputs_.size(), -1);
        depart_.resize(datapath_outputs_.size() / model_->outputs());
        RepousseBatch batch = plain_batch(count, scenario.inputs.data(), engine_outputs_.data());
        uint64_t beats = 0;
        batch.capacity = depart_.size();
        batch.beats = &beats;
        batch.depart = depart_.data();
        batch.seed = random.next();
        uint32_t latency = 1;
        if (stalls != nullptr) {
            batch.source = {stalls->source, stalls->burst};
            batch.sink = {stalls->sink, stalls->burst};
            // A request is four beats or more: memory is at most half asleep, or it alone would
            // set the pace.
            batch.requests = {std::max(stalls->source, 50U), stalls->burst};
            batch.responses = {std::max(stalls->sink, 50U), stalls->burst};
            latency = 1 + random.below(8);
        }
        instance_.configure(scenario.config, scenario.table.get(), latency);
        const RepousseOutcome outcome = instance_.run(batch);
        // Beats that came out before something went wrong tell more than that it did.
        engine_outputs_.resize(beats * model_->outputs());
        scoreboard_.compare(scenario, first, engine_outputs_, datapath_outputs_, depart_.data());
        if (outcome != kRepousseDone) {
            scoreboard_.broken(scenario, first + scoreboard_.items_in(engine_outputs_),
                               outcome_text(outcome));
        }
    }

    std::unique_ptr<UnitModel> model_;
    EngineInstance instance_;
    Scoreboard scoreboard_;
    std::vector<int64_t> engine_outputs_;
    std::vector<int64_t> datapath_outputs_;
    std::vector<uint64_t> depart_;
};

/// Portions of work 0, 1, 2 ... handed to `jobs` threads until one says that there is no more.
class Crew {
public:
    /// `portion(worker, n)` returns the number of transactions done, 0 at the end.
    using Portion = std::function<uint64_t(Worker&, uint64_t n)>;

    Crew(const UnitModel& model, const Engine& engine, const std::string& source, unsigned jobs)
        : total_(model, source) {
        for (unsigned i = 0; i < std::max(jobs, 1U); ++i) {
            workers_.push_back(std::make_unique<Worker>(model, engine, source));
        }
    }

    void work(const Portion& portion, const Progress& progress) {
        std::atomic<uint64_t> next{0};
        std::mutex reporting;
        uint64_t done = 0;
        const auto loop = [&](Worker& worker) {
            for (;;) {
                const uint64_t n = portion(worker, next++);
                if (n == 0) return;
                const std::lock_guard<std::mutex> lock(reporting);
                done += n;
                if (progress) progress(done);
            }
        };
        std::vector<std::thread> threads;
        for (std::size_t i = 1; i < workers_.size(); ++i) {
            threads.emplace_back([&, i] { loop(*workers_[i]); });
        }
        loop(*workers_[0]);
        for (std::thread& thread : threads) thread.join();
    }

    const Scoreboard& total() {
        for (const std::unique_ptr<Worker>& worker : workers_) total_.merge(worker->scoreboard());
        workers_.clear();
        return total_;
    }

private:
    std::vector<std::unique_ptr<Worker>> workers_;
    Scoreboard total_;
};

double seconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

Outcome finish(const UnitModel& model, const Engine& engine, std::string what,
               const Scoreboard& total, std::chrono::steady_clock::time_point start) {
    return {std::string(model.desc().name),
            engine.api().simulator,
            std::move(what),
            total.cases(),
            total.mismatches(),
            seconds_since(start),
            total.first_mismatch()};
}

}  // namespace

Outcome run_random(const UnitModel& model, const Engine& engine,
                   const std::vector<Scenario>& hard_cases, const Effort& effort,
                   const Progress& progress) {
    const auto start = std::chrono::steady_clock::now();
    Crew crew(model, engine, fmt::format("seed {}", effort.seed), effort.jobs);
    uint64_t hard = 0;
    for (const Scenario& scenario : hard_cases) hard += model.count(scenario);

    const auto portion = [&](Worker& worker, uint64_t n) -> uint64_t {
        Random random(effort.seed, n);
        if (n == 0) {  // each hard case at full speed and under every kind of stalls
            uint64_t first = 0;
            for (const Scenario& scenario : hard_cases) {
                worker.run(scenario, first, random, nullptr);
                for (const Stalls& stalls : kStalls) worker.run(scenario, first, random, &stalls);
                first += worker.model().count(scenario);
            }
            return std::max<uint64_t>(hard, 1);
        }
        const std::size_t batch = worker.model().batch();
        const uint64_t from = (n - 1) * batch;
        if (from >= effort.vectors) return 0;
        const auto count =
            static_cast<std::size_t>(std::min<uint64_t>(batch, effort.vectors - from));
        const bool stalled = random.percent(effort.stalled_percent);
        const Stalls& stalls = kStalls[random.below(std::size(kStalls))];
        worker.run(worker.model().random(random, count), hard + from, random,
                   stalled ? &stalls : nullptr);
        return count;
    };
    crew.work(portion, progress);
    return finish(model, engine, "hard + random", crew.total(), start);
}

Outcome run_exhaustive(const UnitModel& model, const Engine& engine, const Effort& effort,
                       const Progress& progress) {
    const auto start = std::chrono::steady_clock::now();
    Crew crew(model, engine, "all of a tiny profile", effort.jobs);
    const auto portion = [&](Worker& worker, uint64_t n) -> uint64_t {
        Random random(effort.seed, n);
        const Scenario scenario = worker.model().exhaustive(n);
        if (scenario.inputs.empty()) return 0;
        worker.run(scenario, n * worker.model().count(scenario), random, nullptr);
        return worker.model().count(scenario);
    };
    crew.work(portion, progress);
    return finish(model, engine, "exhaustive", crew.total(), start);
}

Outcome run_recorded(const UnitModel& model, const Engine& engine, const std::string& what,
                     const Recording& recording, const Effort& effort, const Progress& progress) {
    const auto start = std::chrono::steady_clock::now();
    Worker worker(model, engine, what);
    Random random(effort.seed);
    uint64_t done = 0;
    recording([&](const Recorded& recorded) {
        const bool stalled = random.percent(effort.stalled_percent);
        const Stalls& stalls = kStalls[random.below(std::size(kStalls))];
        worker.run(recorded, done, random, stalled ? &stalls : nullptr);
        done += model.count(recorded.scenario);
        if (progress) progress(done);
    });
    return finish(model, engine, what, worker.scoreboard(), start);
}

}  // namespace repousse::cosim
