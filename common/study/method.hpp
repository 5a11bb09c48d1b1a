// How a shot may be simulated, and in which numbers: what one may choose, and what cannot be.
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <variant>

#include "common/physics/scene.hpp"

namespace breakshot::study {

/// From event to event: common/physics.
struct Exact {};
/// Constant step, corrective detection: fixed.hpp.
struct FixedStep {
  double step_s = 0;  ///< [least_step_s, greatest_step_s]
};
/// Constant step, continuous detection inside it: swept.hpp.
struct SweptStep {
  double step_s = 0;  ///< [least_step_s, greatest_step_s]
};
/// The paper's algorithm as printed: literal.hpp.
struct Literal {
  /// What one call of Progress is asked for; without one, all that is left. The same range.
  std::optional<double> frame_s;
};

using Method = std::variant<Exact, FixedStep, SweptStep, Literal>;

/// The number type of a simulation: 24, 53 and, on x86-64, 64 binary digits, and 50 decimal ones.
enum class Scalar { single_precision, double_precision, long_double, reference };

inline constexpr std::array<std::string_view, 4> scalar_names = {"float", "double", "longdouble",
                                                                 "reference"};

/// Shorter steps are lost in the rounding of times; longer ones see nothing, s.
inline constexpr double least_step_s = 1e-9;
inline constexpr double greatest_step_s = 1e3;

/// What a method cannot simulate of a scene, or what is wrong with its step (field "dt"); none if
/// it can. The scene must be free of faults.
std::optional<physics::Fault> refusal_of(const Method& method, const physics::Scene& scene);

}  // namespace breakshot::study
