#include "bench/study/measure.hpp"

#include <algorithm>
#include <array>
#include <fstream>
#include <memory>
#include <utility>

#include "bench/study/instructions.hpp"
#include "bench/study/point.hpp"
#include "bench/study/sets.hpp"
#include "bench/study/variation.hpp"
#include "bench/timing.hpp"
#include "common/study/compare.hpp"
#include "common/study/shots.hpp"

namespace breakshot::bench {
namespace {

/// What the full model is varied on.
constexpr std::array<std::string_view, 4> varied_sets = {"break_full", "cut", "safety", "kick"};

/// The paper looks at all pairs after every collision: a thousand balls would take minutes.
constexpr std::size_t most_literal = 200;

study::Simulation simulation(const wire::Scenario& s, const Point& point) {
  return {point.the_method(), point.the_scalar(), {s.scene, s.state, s.strike, s.seed, s.limits}};
}

std::optional<physics::BallId> struck_in(const wire::Scenario& s) {
  return s.strike ? std::optional(s.strike->ball) : std::nullopt;
}

std::string processor() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    if (!line.starts_with("model name")) continue;
    std::string name = line.substr(line.find(':') + 2);
    std::replace(name.begin(), name.end(), ',', ' ');
    return name;
  }
  return "unknown";
}

double share(std::size_t part, std::size_t whole) {
  return whole == 0 ? 0 : static_cast<double>(part) / static_cast<double>(whole);
}

/// The comparisons of all shots of a set.
class Sum {
 public:
  void add(const study::Comparison& one) {
    ++shots_;
    for (std::size_t k = 0; k < one.contacts.size(); ++k) join(contacts_[k], one.contacts[k]);
    join(end_, one.end);
    overlap_m_ = std::max(overlap_m_, one.overlap_m);
    energies_.push_back(one.energy);
    first_contact_ += one.first_contact;
    cushions_ += one.cushions;
    pocketed_ += one.pocketed;
    outcome_ += one.outcome();
  }

  void put_outcome(Row& row) const {
    row["first_contact"] = shown(share(first_contact_, shots_));
    row["cushions"] = shown(share(cushions_, shots_));
    row["pocketed"] = shown(share(pocketed_, shots_));
    row["outcome"] = shown(share(outcome_, shots_));
  }

  void put(Row& row) const {
    put_outcome(row);
    row["overlap_m"] = shown(overlap_m_);
    row["energy"] = shown(median(energies_));
  }

  void put_errors(const Row& key, TableFile& file) const {
    for (std::size_t k = 0; k < contacts_.size(); ++k) {
      put_errors(key, std::to_string(k + 1), contacts_[k], file);
    }
    put_errors(key, "end", end_, file);
  }

 private:
  static void join(study::ContactErrors& sum, const study::ContactErrors& one) {
    sum.balls += one.balls;
    sum.wrong += one.wrong;
    sum.times_s.insert(sum.times_s.end(), one.times_s.begin(), one.times_s.end());
    sum.positions_m.insert(sum.positions_m.end(), one.positions_m.begin(), one.positions_m.end());
  }

  static void put_errors(Row row, const std::string& contacts, const study::ContactErrors& errors,
                         TableFile& file) {
    row["contacts"] = contacts;
    row["balls"] = std::to_string(errors.balls);
    row["wrong"] = shown(share(errors.wrong, errors.balls));
    if (!errors.times_s.empty()) row["time_s"] = shown(median(errors.times_s));
    if (!errors.positions_m.empty()) row["position_m"] = shown(median(errors.positions_m));
    file.add(row);
  }

  std::size_t shots_ = 0;
  std::array<study::ContactErrors, study::most_contacts> contacts_;
  study::ContactErrors end_;
  double overlap_m_ = 0;
  std::vector<double> energies_;
  std::size_t first_contact_ = 0;
  std::size_t cushions_ = 0;
  std::size_t pocketed_ = 0;
  std::size_t outcome_ = 0;
};

/// One set's shots, and what the reference says of them once it has been asked.
class Studied {
 public:
  Studied(const Set& set, std::uint32_t shots) : set_(set) {
    for (std::uint32_t number = 0; number < shots; ++number) shots_.push_back(set.shot(number));
  }

  const std::string name() const { return std::string(set_.name); }
  const std::vector<wire::Scenario>& shots() const { return shots_; }

  const std::vector<study::WideShot>& truth() {
    if (truth_.empty()) {
      for (const wire::Scenario& shot : shots_) {
        study::Simulation run = simulation(shot, {"exact", "reference", "-"});
        run.advance_to(physics::never<double>);
        truth_.push_back(run.wide_shot());
      }
    }
    return truth_;
  }

 private:
  const Set& set_;
  std::vector<wire::Scenario> shots_;
  std::vector<study::WideShot> truth_;
};

void measure_point(Studied& set, const Point& point, const Row& key, StudyFiles& files,
                   const StudyOptions& options) {
  Sum sum;
  double spent_s = 0;
  std::size_t events = 0;
  for (std::size_t i = 0; i < set.shots().size(); ++i) {
    const wire::Scenario& shot = set.shots()[i];
    const double before_s = thread_seconds();
    study::Simulation run = simulation(shot, point);
    run.advance_to(physics::never<double>);
    spent_s += thread_seconds() - before_s;
    const study::WideShot outcome = run.wide_shot();
    events += outcome.events.size();
    sum.add(study::compare(outcome, set.truth()[i], shot.scene, struck_in(shot)));
  }
  const double one_s = spent_s / static_cast<double>(set.shots().size());
  Row row = key;
  row["cpu_us"] = shown(1e6 * one_s);
  row["events"] = shown(static_cast<double>(events) / static_cast<double>(set.shots().size()));
  row["processor"] = processor();
  // Callgrind computes long double in 64 bits: what is counted would be something else.
  if (point.the_scalar() != study::Scalar::long_double) {
    const auto instructions =
        instructions_a_shot({options.folder + "/study", "simulate", set.name(), point.method,
                             point.scalar, point.step_s},
                            one_s, set.shots().size());
    if (instructions) row["instructions"] = shown(*instructions);
  }
  sum.put(row);
  sum.put_errors(key, files.errors);
  files.points.add(row);
}

void measure_variation(Studied& set, std::size_t index, const Row& key, StudyFiles& files,
                       const StudyOptions& options) {
  const Variation& variation = variations()[index];
  Sum sum;
  double spent_s = 0;
  std::size_t events = 0;
  for (const wire::Scenario& whole : set.shots()) {
    wire::Scenario shot = whole;
    variation.change(shot);
    const double before_s = thread_seconds();
    const physics::Shot outcome = shot_of(shot, variation.cells);
    spent_s += thread_seconds() - before_s;
    events += outcome.events.size();
    if (variation.same_balls) {
      sum.add(study::compare(study::shot_as<study::Reference>(outcome),
                             study::shot_as<study::Reference>(shot_of(whole, false)), whole.scene,
                             struck_in(whole)));
    }
  }
  const double one_s = spent_s / static_cast<double>(set.shots().size());
  Row row = key;
  row["cpu_us"] = shown(1e6 * one_s);
  row["events"] = shown(static_cast<double>(events) / static_cast<double>(set.shots().size()));
  const auto instructions = instructions_a_shot(
      {options.folder + "/study", "simulate", set.name(), std::to_string(index)}, one_s,
      set.shots().size());
  if (instructions) row["instructions"] = shown(*instructions);
  if (variation.same_balls) sum.put_outcome(row);
  files.needs.add(row);
}

/// A break on straight paths, without jaws or friction at contacts.
constexpr const char* plain_scene = "break_8ft.json";

void measure_engine(const Row& key, StudyFiles& files, const StudyOptions& options) {
  Row row = key;
  const auto instructions =
      instructions_a_shot_between({options.folder + "/" + key.at("program"), plain_scene}, 20, 120);
  if (instructions) row["instructions"] = shown(*instructions);
  files.engines.add(row);
}

/// A row that is to be there.
struct Task {
  std::string what;
  bool done = false;
  std::function<void()> run;
};

}  // namespace

StudyFiles::StudyFiles(const std::string& directory)
    : points(
          directory + "/points.csv",
          {"set", "method", "scalar", "step_s", "shots", "cpu_us", "instructions", "events",
           "overlap_m", "energy", "first_contact", "cushions", "pocketed", "outcome", "processor"}),
      errors(directory + "/errors.csv", {"set", "method", "scalar", "step_s", "shots", "contacts",
                                         "balls", "wrong", "time_s", "position_m"}),
      needs(directory + "/requires.csv",
            {"set", "phenomenon", "choice", "shots", "cpu_us", "instructions", "events",
             "first_contact", "cushions", "pocketed", "outcome"}),
      engines(directory + "/engines.csv", {"engine", "program", "instructions"}),
      determinism(directory + "/determinism.csv",
                  {"build", "how", "lines", "differ", "built_s", "ran_s"}) {}

void measure(StudyFiles& files, const StudyOptions& options) {
  std::vector<Task> tasks;
  for (const Set& set : sets()) {
    const std::uint32_t shots = options.full ? set.full : set.quick;
    const auto studied = std::make_shared<Studied>(set, shots);
    for (const Point& point : points(options.full)) {
      if (refusal_of(point.the_method(), studied->shots().front().scene)) continue;
      if (point.method == "literal" && studied->shots().front().state.balls.size() > most_literal) {
        continue;
      }
      const Row key = {{"set", studied->name()},
                       {"method", point.method},
                       {"scalar", point.scalar},
                       {"step_s", point.step_s},
                       {"shots", std::to_string(shots)}};
      tasks.push_back(
          {studied->name() + ": " + point.method + ", " + point.scalar + ", step " + point.step_s,
           files.points.find(key) != nullptr,
           [=, &files] { measure_point(*studied, point, key, files, options); }});
    }
    if (std::find(varied_sets.begin(), varied_sets.end(), set.name) == varied_sets.end()) continue;
    for (std::size_t i = 0; i < variations().size(); ++i) {
      const Row key = {{"set", studied->name()},
                       {"phenomenon", std::string(variations()[i].phenomenon)},
                       {"choice", std::string(variations()[i].choice)},
                       {"shots", std::to_string(shots)}};
      tasks.push_back({studied->name() + ": " + key.at("phenomenon") + ", " + key.at("choice"),
                       files.needs.find(key) != nullptr,
                       [=, &files] { measure_variation(*studied, i, key, files, options); }});
    }
  }
  for (const auto& [engine, program] :
       {std::pair{"with everything", "count_breaks"},
        std::pair{"without spin or friction of contacts or jaws", "count_breaks_plain"}}) {
    const Row key = {{"engine", engine}, {"program", program}};
    tasks.push_back({"a plain break by " + std::string(program), files.engines.find(key) != nullptr,
                     [=, &files, &options] { measure_engine(key, files, options); }});
  }
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    options.progress(i, tasks.size(), tasks[i].what);
    if (!tasks[i].done) tasks[i].run();
    tasks[i].run = nullptr;
  }
  options.progress(tasks.size(), tasks.size(), "done");
}

void simulate_only(const std::vector<std::string>& words, std::size_t shots) {
  const Set& set = set_of(words.at(0));
  for (std::uint32_t number = 0; number < shots; ++number) {
    wire::Scenario shot = set.shot(number);
    if (words.size() == 2) {
      const Variation& variation = variations().at(std::stoul(words[1]));
      variation.change(shot);
      shot_of(shot, variation.cells);
    } else {
      simulation(shot, {words.at(1), words.at(2), words.at(3)}).advance_to(physics::never<double>);
    }
  }
}

}  // namespace breakshot::bench
