#include "common/study/method.hpp"

#include <type_traits>

namespace breakshot::study {
namespace {

using physics::Fault;

std::optional<double> step_of(const Method& method) {
  return std::visit(
      [](const auto& m) -> std::optional<double> {
        if constexpr (requires { m.step_s; }) {
          return m.step_s;
        } else if constexpr (requires { m.frame_s; }) {
          return m.frame_s;
        } else {
          return std::nullopt;
        }
      },
      method);
}

/// The paper's balls move on straight paths between straight cushions with pockets in them.
std::optional<Fault> beyond_the_paper(const physics::Scene& scene) {
  if (std::holds_alternative<physics::Spinning>(scene.bed.motion)) {
    return Fault{"scene.bed.motion.spinning",
                 "the literal method knows straight paths only; use straight or frictionless"};
  }
  const auto* free =
      scene.cushions ? std::get_if<physics::FreeCushions>(&*scene.cushions) : nullptr;
  if (free != nullptr && !free->arcs.empty()) {
    return Fault{"scene.cushions.arcs", "the literal method knows straight cushions only"};
  }
  if (scene.pockets && std::holds_alternative<physics::JawedPockets>(*scene.pockets)) {
    return Fault{"scene.pockets.jawed", "the literal method knows no jaws; use standard"};
  }
  return std::nullopt;
}

}  // namespace

std::optional<Fault> refusal_of(const Method& method, const physics::Scene& scene) {
  const std::optional<double> step = step_of(method);
  if (step && !(*step >= least_step_s && *step <= greatest_step_s)) {
    return Fault{"dt", "must be from 1e-9 to 1000 s"};
  }
  if (std::holds_alternative<Literal>(method)) return beyond_the_paper(scene);
  return std::nullopt;
}

}  // namespace breakshot::study
