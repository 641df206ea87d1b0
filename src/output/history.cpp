#include "output/history.hpp"

namespace gearfilm {
namespace {

TableColumn column_of(std::string_view name, const Unit& unit) {
  return {std::string(name), std::string(unit.name), unit.whole};
}

template <class Keys, class Quantities>
std::vector<TableColumn> columns_of(const Keys& keys, const Quantities& quantities, const AvailableModels& given) {
  std::vector<TableColumn> columns;
  columns.reserve(keys.size() + quantities.size());
  for (const RowKey& key : keys) columns.push_back(column_of(key.name, key.unit));
  for (const auto& quantity : quantities) {
    if (given.has(quantity.needs)) columns.push_back(column_of(quantity.name, quantity.unit));
  }
  return columns;
}

}  // namespace

History::History(ResultsFile& file, const MeshModel& mesh, bool lubricated)
    : mesh_(mesh),
      given_(available_models(mesh, lubricated)),
      steps_(file, "/history/steps", columns_of(step_keys, step_quantities, given_)),
      contacts_(file, "/history/contacts", columns_of(contact_keys, contact_quantities, given_)) {}

void History::append(const StepRecord& record) {
  std::vector<double> rows;
  for (const ContactRecord& contact : record.contacts) {
    rows.insert(rows.end(), {static_cast<double>(step_), static_cast<double>(contact.number), record.T,
                             mesh_.scales.time * record.T, contact.position});
    for (std::size_t n = 0; n < contact_quantities.size(); ++n) {
      if (!given_.has(contact_quantities[n].needs)) continue;
      rows.push_back(contact_quantities[n].unit.in_si(mesh_.scales, contact.quantities.values[n]));
    }
  }
  if (!rows.empty()) contacts_.append(rows);
  std::vector<double> row = {static_cast<double>(step_),    record.T,
                             mesh_.scales.time * record.T,  record.dT,
                             mesh_.path.distance(record.T), mesh_.path.rpm(record.T)};
  for (const auto& quantity : step_quantities) {
    if (given_.has(quantity.needs)) row.push_back(quantity.unit.in_si(mesh_.scales, quantity.value(record)));
  }
  steps_.append(row);
  ++step_;
}

void History::write() {
  steps_.write();
  contacts_.write();
}

}  // namespace gearfilm
