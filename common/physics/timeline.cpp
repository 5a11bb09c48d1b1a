#include "common/physics/timeline.hpp"

#include <algorithm>

namespace breakshot::physics {

Timeline::Timeline(const Shot& shot) : end_s_(shot.end_s) {
  for (const Segment& s : shot.segments) balls_.push_back(s.ball);
  std::sort(balls_.begin(), balls_.end());
  balls_.erase(std::unique(balls_.begin(), balls_.end()), balls_.end());
  paths_.resize(balls_.size());
  for (const Segment& s : shot.segments) paths_[index_of(s.ball)].push_back(s);
}

std::size_t Timeline::index_of(BallId ball) const {
  return static_cast<std::size_t>(std::lower_bound(balls_.begin(), balls_.end(), ball) -
                                  balls_.begin());
}

BallState Timeline::state(BallId ball, double time_s) const {
  const std::vector<Segment>& path = this->path(ball);
  const double t = std::clamp(time_s, 0.0, end_s_);
  const auto after = std::upper_bound(
      path.begin(), path.end(), t, [](double time, const Segment& s) { return time < s.start_s; });
  const Segment& s = after == path.begin() ? path.front() : *(after - 1);
  return {ball, s.phase, position_at(s, t), velocity_at(s, t), spin_at(s, t)};
}

std::vector<BallState> Timeline::states(double time_s) const {
  std::vector<BallState> all;
  all.reserve(balls_.size());
  for (const BallId ball : balls_) all.push_back(state(ball, time_s));
  return all;
}

const std::vector<Segment>& Timeline::path(BallId ball) const {
  return paths_[index_of(ball)];
}

State state_after(const Shot& shot) {
  State state;
  const Timeline timeline(shot);
  for (const BallState& ball : timeline.states(shot.end_s)) {
    if (ball.phase != Phase::pocketed) state.balls.push_back({ball.id, ball.position, {}, {}});
  }
  return state;
}

}  // namespace breakshot::physics
