#include "common/study/simulation.hpp"

namespace breakshot::study {
namespace {

std::unique_ptr<Running> running(const Method& method, Scalar scalar, const Input& input) {
  switch (scalar) {
    case Scalar::single_precision:
      return running_in<float>(method, input);
    case Scalar::long_double:
      return running_in<long double>(method, input);
    case Scalar::reference:
      return running_in<Reference>(method, input);
    case Scalar::double_precision:
      break;
  }
  return running_in<double>(method, input);
}

}  // namespace

Simulation::Simulation(const Method& method, Scalar scalar, const Input& input)
    : running_(running(method, scalar, input)) {}

physics::Shot Simulation::shot_until(double time_s) const {
  physics::Shot shot = this->shot();
  shot.stop = physics::Stop::horizon;
  shot.end_s = time_s;
  return shot;
}

}  // namespace breakshot::study
