#include "bench/study/variation.hpp"

#include <algorithm>

#include "common/physics/simulation.hpp"

namespace breakshot::bench {
namespace {

using namespace physics;

void straight(wire::Scenario& s) {
  s.scene.bed.motion = Straight{0.2, 0.01, 1.0};
  if (s.strike) s.strike->tip = {};
}

template <class Model>
void balls(wire::Scenario& s) {
  s.scene.ball_ball = Model{};
}

void ghosts(wire::Scenario& s) {
  s.scene.ball_ball.reset();
}

template <class Model>
void cushions(wire::Scenario& s) {
  Model model;
  if constexpr (requires { model.height_m; }) model.height_m = 1.27 * s.scene.ball.radius_m;
  s.scene.cushions = RectangleCushions{model};
}

void mouths(wire::Scenario& s) {
  s.scene.pockets = StandardPockets{};
}

void no_pockets(wire::Scenario& s) {
  s.scene.pockets.reset();
}

void perturbed(wire::Scenario& s) {
  s.scene.perturbation = Perturbation{0.0005, 0.0005};
}

template <std::size_t count>
void fewer(wire::Scenario& s) {
  s.state.balls.resize(std::min(count, s.state.balls.size()));
}

/// Nothing but rolling, bouncing balls on an open table.
void least(wire::Scenario& s) {
  straight(s);
  balls<BallRestitution>(s);
  cushions<CushionRestitution>(s);
  no_pockets(s);
}

}  // namespace

const std::vector<Variation>& variations() {
  static const std::vector<Variation> all = {
      {"full model", "everything", [](wire::Scenario&) {}},
      {"motion", "straight", straight},
      {"contact of balls", "restitution", balls<BallRestitution>},
      {"contact of balls", "elastic", balls<Elastic>},
      {"contact of balls", "mathavan2014", balls<Mathavan2014>},
      {"contact of balls", "none", ghosts},
      {"cushions", "restitution", cushions<CushionRestitution>},
      {"cushions", "mirror", cushions<Mirror>},
      {"cushions", "mathavan2010", cushions<Mathavan2010>},
      {"cushions", "stronge2000", cushions<Stronge2000>},
      {"pockets", "standard (no jaws)", mouths},
      {"pockets", "none", no_pockets},
      {"perturbation", "0.0005 of normals", perturbed},
      {"all of these", "straight + restitution + no pockets", least},
      {"calendar", "cells", [](wire::Scenario&) {}, true, true},
      {"balls", "at most 2", fewer<2>, false},
      {"balls", "at most 4", fewer<4>, false},
      {"balls", "at most 8", fewer<8>, false},
  };
  return all;
}

Shot shot_of(const wire::Scenario& s, bool cells) {
  if (cells) {
    Loop<double, CellCalendar> loop(s.scene, s.state, s.strike, s.seed, s.limits);
    loop.advance_to(never<double>);
    return loop.shot();
  }
  Simulation simulation(s.scene, s.state, s.strike, s.seed, s.limits);
  simulation.advance_to(never<double>);
  return simulation.shot();
}

}  // namespace breakshot::bench
