#include "output/results_docs.hpp"

#include <array>
#include <sstream>

#include "dynamics/contact_fields.hpp"
#include "dynamics/period_quantities.hpp"
#include "output/history.hpp"

namespace gearfilm {
namespace {

std::string code(std::string_view text) {
  std::string quoted(text);
  if (!quoted.empty()) quoted.insert(0, 1, '`').push_back('`');
  return quoted;
}

std::string condition(RequiredModel needs) {
  constexpr std::array conditions = {"",
                                     "; not in the dry model",
                                     "; with `friction.law`",
                                     "; with `thermal.model`",
                                     "; with `pinion.roughness` or `wheel.roughness`",
                                     "; with `roughness.model`",
                                     "; with `roughness.model` and a law of summits",
                                     "; with `roughness.model` and `friction.law`",
                                     "; with `roughness.model` and a coefficient of wear",
                                     "; with `stress.model`",
                                     "; with any limit of `rating`",
                                     "; with `rating.root_limit`",
                                     "; with any limit of `rating` and roughness of both flanks",
                                     "; with any limit of `rating` and `friction.law`"};
  return conditions.at(static_cast<std::size_t>(needs));
}

template <class Keys, class Quantities>
void describe_table(std::ostream& text, std::string_view name, std::string_view rows, const Keys& keys,
                    const Quantities& quantities) {
  text << "\n## " << code(name) << "\n\n" << rows << "\n\n| Column | Symbol | Unit | Meaning |\n|---|---|---|---|\n";
  for (const RowKey& key : keys)
    text << "| " << code(key.name) << " | | " << key.unit.name << " | " << key.meaning << " |\n";
  for (const auto& quantity : quantities) {
    text << "| " << code(quantity.name) << " | " << code(quantity.symbol) << (quantity.symbol.empty() ? "| " : " | ")
         << quantity.unit.name << " | " << quantity.meaning << condition(quantity.needs) << " |\n";
  }
}

void describe_periods(std::ostream& text) {
  text
      << "\n## Quantities of a mesh period\n\n"
         "Keys of the summaries of `periodic`, of each point of `sweep`, and of each of the `periods` of `transient`.\n"
         "Those marked *march* stand in the summary of `transient` for all periods together as well, those marked\n"
         "*sweep* are columns of the table `/sweep`.\n\n"
         "| Key | Unit | Meaning | Also in |\n|---|---|---|---|\n";
  for (const PeriodQuantity& quantity : period_quantities) {
    const std::string march = quantity.of_march() ? "march" : "", sweep = quantity.of_sweep() ? "sweep" : "";
    text << "| " << code(quantity.name) << " | " << quantity.unit.name << " | " << quantity.meaning
         << condition(quantity.needs) << " | " << march << (march.empty() || sweep.empty() ? "" : ", ") << sweep
         << (march.empty() && sweep.empty() ? "|\n" : " |\n");
  }
}

void describe_fields(std::ostream& text) {
  text << "\n## Fields of a film\n\n"
          "Datasets of `/contact0` (`steady`) and of `/snapshots/NNNN/contactK` (marches), on the nodes (x, y); those "
          "of "
          "friction\nand heat where the case has them.\n\n| Dataset | Unit | Meaning |\n|---|---|---|\n";
  const auto describe = [&](const ContactField& field) {
    text << "| " << code(field.dataset) << " | " << field.unit.name << " | " << field.meaning << " |\n";
  };
  for (const ContactField& field :
       {field::pressure, field::thickness, field::film_pressure, field::asperity_pressure, field::mean_gap}) {
    describe(field);
  }
  for (const auto& field : field::traction) describe(field.field);
}

}  // namespace

std::string quantities_markdown() {
  std::ostringstream text;
  text << "# Quantities\n\n"
          "This page is the output of `gearfilm figures`.\n\n"
          "The history of `transient` and `periodic` in `results.h5`, and what mesh periods keep of it. Everything is "
          "SI\n"
          "but for the pure numbers. The summary of `steady` has the quantities of its contact under the names of the\n"
          "columns of `/history/contacts`.\n";
  describe_table(text, "/history/steps", "One row a time step.", step_keys, step_quantities);
  describe_table(text, "/history/contacts", "One row a contact and time step.", contact_keys, contact_quantities);
  describe_periods(text);
  describe_fields(text);
  return text.str();
}

}  // namespace gearfilm
