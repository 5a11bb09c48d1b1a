#include "server/shell/shell.hpp"

#include <spdlog/spdlog.h>
#include <unistd.h>

#include <boost/asio/io_context.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/signal_set.hpp>
#include <boost/asio/steady_timer.hpp>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <deque>
#include <system_error>
#include <utility>
#include <variant>

#include "server/hub/hub.hpp"
#include "server/net/switchboard.hpp"
#include "server/shell/limits.hpp"
#include "server/store/store.hpp"

namespace breakshot::shell {
namespace asio = boost::asio;

namespace {

hub::Now now() {
  using std::chrono::duration_cast, std::chrono::milliseconds;
  const auto steady = std::chrono::steady_clock::now().time_since_epoch();
  const auto date = std::chrono::system_clock::now().time_since_epoch();
  return {duration_cast<milliseconds>(steady), duration_cast<milliseconds>(date).count()};
}

hub::Entropy fresh_entropy() {
  hub::Entropy entropy;
  if (::getentropy(entropy.data(), entropy.size()) != 0) {
    throw std::system_error(errno, std::generic_category(), "the system gives no random bytes");
  }
  return entropy;
}

}  // namespace

class Shell::Works {
 public:
  explicit Works(const Settings& settings)
      : hub_(settings.version, settings.hub),
        signals_(context_, SIGTERM, SIGINT),
        tick_(context_),
        store_(store::open_sqlite(settings.database, reporter())) {
    store_->restore([this](ledger::Restored restored) { feed(std::move(restored)); });
    switchboard_ =
        std::make_unique<net::Switchboard>(context_, settings.address, settings.port, settings.net,
                                           [this](net::Heard heard) { hear(std::move(heard)); });
  }

  std::uint16_t port() const { return switchboard_->port(); }

  void run() {
    signals_.async_wait([this](boost::system::error_code error, int) {
      if (!error) stop();
    });
    tick();
    context_.run();
  }

 private:
  // ---- Inputs

  /// The store reports on threads of its own.
  store::Reporter reporter() {
    return [this](ledger::Report report) {
      asio::post(context_, [this, kept = std::move(report)]() mutable { feed(std::move(kept)); });
    };
  }

  void hear(net::Heard heard) {
    if (auto* asked = std::get_if<net::Asked>(&heard)) {
      return feed(hub::Asked{asked->connection, std::move(asked->asked), fresh_entropy()});
    }
    if (const auto* opened = std::get_if<hub::Opened>(&heard)) return feed(*opened);
    if (const auto* drained = std::get_if<hub::Drained>(&heard)) return feed(*drained);
    feed(std::get<hub::Closed>(heard));
  }

  void tick() {
    feed(hub::Tick{});
    tick_.expires_after(tick_interval);
    tick_.async_wait([this](boost::system::error_code error) {
      if (!error && !stopped_) tick();
    });
  }

  void stop() {
    spdlog::info("stopping: storing what is under way and saying goodbye");
    signals_.clear();  // from now on a signal does what signals do
    switchboard_->stop_listening();
    feed(hub::Stopping{});
  }

  /// What is performed may be heard of at once: such inputs wait until the outputs before them have
  /// been carried out.
  void feed(hub::Input input) {
    inputs_.push_back(std::move(input));
    if (stepping_) return;
    stepping_ = true;
    while (!inputs_.empty()) {
      hub::Input next = std::move(inputs_.front());
      inputs_.pop_front();
      for (hub::Output& output : hub_.step(std::move(next), now())) {
        std::visit([this](auto& what) { perform(what); }, output);
      }
    }
    stepping_ = false;
  }

  // ---- Outputs

  void perform(const hub::Tell& tell) { switchboard_->tell(tell.to, *tell.told); }
  void perform(const hub::ReportDrained& report) {
    switchboard_->report_drained(report.connection);
  }
  void perform(const hub::Close& close) { switchboard_->close(close.connection); }
  void perform(const hub::Treat& treat) { switchboard_->treat(treat.connection, treat.as); }
  void perform(hub::Append& append) { store_->append(append.ticket, std::move(append.batch)); }
  void perform(hub::Load& load) { store_->load(load.ticket, std::move(load.query)); }
  void perform(const hub::Note& note) {
    const auto level = hub::is_alarming(note) ? spdlog::level::warn : spdlog::level::info;
    spdlog::log(level, hub::sentence_of(note));
  }
  void perform(const hub::Stopped&) {
    stopped_ = true;
    tick_.cancel();
    // The last words are still on their way; net closes every connection by its deadline.
    switchboard_->when_empty([this] { context_.stop(); });
  }

  // The context outlives all that posts to it: the store reports what it carries out at its end.
  asio::io_context context_{1};
  hub::Hub hub_;
  asio::signal_set signals_;  ///< one that comes before run() waits for it
  asio::steady_timer tick_;
  std::deque<hub::Input> inputs_;
  bool stepping_ = false;
  bool stopped_ = false;
  std::unique_ptr<net::Switchboard> switchboard_;
  std::unique_ptr<store::Store> store_;
};

Shell::Shell(const Settings& settings) : works_(std::make_unique<Works>(settings)) {}
Shell::~Shell() = default;

std::uint16_t Shell::port() const {
  return works_->port();
}

void Shell::run() {
  works_->run();
}

}  // namespace breakshot::shell
