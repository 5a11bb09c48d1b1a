#include "client_cli/fetch.hpp"

#include "client_cli/command_error.hpp"
#include "client_cli/online/connection.hpp"
#include "client_cli/online/match_name.hpp"

namespace breakshot::client {

std::variant<record::Record, Failure> fetch_record(const ServerAddress& server, const Guest& guest,
                                                   const std::string& id_or_code) {
  const auto name = match_name_of(id_or_code);
  if (!name) return Failure{"names no match: that takes 16 hexadecimal digits or an invite code"};
  try {
    Connection connection(server, guest, notice_on_standard_error());
    auto fetched = connection.fetch({name->id, name->code, {}});
    if (const auto* refused = std::get_if<lobby::Refused>(&fetched)) return Failure{refused->what};
    return std::get<record::Record>(std::move(fetched));
  } catch (const CommandError& error) {
    return Failure{error.what()};
  }
}

}  // namespace breakshot::client
