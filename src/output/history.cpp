#include "gearfilm/output/history.hpp"

namespace gearfilm {
namespace {

TableColumn column_of(std::string_view name, const Unit& unit) {
  return {std::string(name), std::string(unit.name), unit.whole};
}

std::vector<TableColumn> step_columns() {
  std::vector<TableColumn> columns;
  columns.reserve(step_keys.size() + step_figures.size());
  for (const RowKey& key : step_keys) columns.push_back(column_of(key.name, key.unit));
  for (const auto& figure : step_figures) columns.push_back(column_of(figure.name, figure.unit));
  return columns;
}

bool is_there(const Figure<ContactMoment>& figure, bool lubricated) {
  return lubricated || figure.needs != Needs::film;
}

std::vector<TableColumn> contact_columns(bool lubricated) {
  std::vector<TableColumn> columns;
  columns.reserve(contact_keys.size() + contact_figures.size());
  for (const RowKey& key : contact_keys) columns.push_back(column_of(key.name, key.unit));
  for (const auto& figure : contact_figures) {
    if (is_there(figure, lubricated)) columns.push_back(column_of(figure.name, figure.unit));
  }
  return columns;
}

}  // namespace

History::History(ResultsFile& file, const MeshModel& mesh, bool lubricated)
    : mesh_(mesh),
      lubricated_(lubricated),
      steps_(file, "/history/steps", step_columns()),
      contacts_(file, "/history/contacts", contact_columns(lubricated)) {}

void History::append(const StepRecord& record) {
  std::vector<double> rows;
  for (const ContactRecord& contact : record.contacts) {
    rows.insert(rows.end(),
                {static_cast<double>(step_), static_cast<double>(contact.number), record.T, contact.position});
    for (std::size_t n = 0; n < contact_figures.size(); ++n) {
      if (!is_there(contact_figures[n], lubricated_)) continue;
      rows.push_back(contact_figures[n].unit.in_si(mesh_.scales, contact.figures.values[n]));
    }
  }
  if (!rows.empty()) contacts_.append(rows);
  std::vector<double> row = {static_cast<double>(step_), record.T, mesh_.scales.time * record.T, record.dT,
                             mesh_.path.distance(record.T)};
  for (const auto& figure : step_figures) row.push_back(figure.unit.in_si(mesh_.scales, figure.value(record)));
  steps_.append(row);
  ++step_;
}

void History::write() {
  steps_.write();
  contacts_.write();
}

}  // namespace gearfilm
