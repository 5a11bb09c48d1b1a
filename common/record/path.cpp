#include "common/record/path.hpp"

namespace breakshot::record {

std::string Path::text() const {
  std::string text;
  for (const Step& step : steps_) {
    if (step.field.empty()) {
      text += '[' + std::to_string(step.index) + ']';
    } else {
      if (!text.empty()) text += '.';
      text += step.field;
    }
  }
  return text;
}

}  // namespace breakshot::record
