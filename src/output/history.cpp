#include "gearfilm/output/history.hpp"

namespace gearfilm {
namespace {

std::vector<TableColumn> step_columns() {
  return {{"step", "-", true},
          {"T", "-"},
          {"t", "s"},
          {"dT", "-"},
          {"distance", "m"},
          {"H0", "-"},
          {"V0", "-"},
          {"h0", "m"},
          {"force_total", "N"},
          {"contacts", "-", true},
          {"newton", "-", true},
          {"krylov", "-", true},
          {"wall_time", "s"}};
}

std::vector<TableColumn> contact_columns(bool lubricated) {
  std::vector<TableColumn> columns = {{"step", "-", true}, {"contact", "-", true}, {"T", "-"},
                                      {"xi", "m"},         {"force", "N"},         {"p_max", "Pa"}};
  if (lubricated) {
    columns.insert(columns.end(), {{"p_central", "Pa"}, {"h_central", "m"}, {"h_min", "m"}});
  }
  return columns;
}

}  // namespace

History::History(ResultsFile& file, const Scales& scales, const ContactPath& path, bool lubricated)
    : scales_(scales),
      path_(path),
      lubricated_(lubricated),
      steps_(file, "/history/steps", step_columns()),
      contacts_(file, "/history/contacts", contact_columns(lubricated)) {}

void History::append(const StepRecord& record) {
  std::vector<double> rows;
  for (const ContactRecord& contact : record.contacts) {
    const FilmFigures& figures = contact.figures;
    rows.insert(rows.end(),
                {static_cast<double>(step_), static_cast<double>(contact.contact), record.T, contact.position,
                 scales_.force(figures.pressure_integral), scales_.pressure * figures.largest_pressure});
    if (lubricated_) {
      rows.insert(rows.end(), {scales_.pressure * figures.central_pressure, scales_.film * figures.central_film,
                               scales_.film * figures.smallest_film});
    }
  }
  if (!rows.empty()) contacts_.append(rows);
  steps_.append({static_cast<double>(step_), record.T, scales_.time * record.T, record.dT, path_.distance(record.T),
                 record.motion.H0, record.motion.V0, scales_.film * record.motion.H0,
                 scales_.force(record.pressure_integral()), static_cast<double>(record.contacts.size()),
                 static_cast<double>(record.newton), static_cast<double>(record.krylov), record.wall_seconds});
  ++step_;
}

void History::write() {
  steps_.write();
  contacts_.write();
}

}  // namespace gearfilm
