#include "gearfilm/results.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <stdexcept>

#include "interface/views.hpp"
#include "output/output_directory.hpp"
#include "output/results_table.hpp"
#include "output/run_identity.hpp"
#include "parallel/agreement.hpp"

namespace gearfilm {

Results::Results() : Results(Content{}) {}
Results::Results(Content content) : content_(std::make_shared<const Content>(std::move(content))) {}

bool Results::has(const std::string& name) const {
  const auto found = content_->summary.find(name);
  return found != content_->summary.end() && found->is_number();
}

double Results::number(const std::string& name) const {
  if (!has(name)) throw std::out_of_range("the results have no number '" + name + "'");
  return content_->summary[name].get<double>();
}

void Results::set(const std::string& name, double value) {
  Content changed = *content_;
  changed.summary[name] = value;
  content_ = std::make_shared<const Content>(std::move(changed));
}

std::string Results::json() const { return content_->summary.dump(2); }

int Film::nx() const { return view_->film->grid().nx(); }
int Film::rows() const { return view_->film->grid().y_count(); }
double Film::x(int i) const { return view_->film->scales().length * view_->film->grid().x(i); }
double Film::y(int j) const { return view_->film->scales().length * view_->film->grid().y(j); }

double Film::pressure(int i, int j) const {
  return view_->film->scales().pressure * view_->film->total_pressure().row(i)[j];
}

double Film::thickness(int i, int j) const {
  return view_->film->scales().thickness * view_->film->thickness().row(i)[j];
}

namespace {

/// An action that may fail on some of the processes only: InputError on all.
template <class Action>
void require_on_all(MPI_Comm comm, Action action) {
  const std::string reason = first_of_all_reasons(comm, reason_against(action));
  if (!reason.empty()) throw InputError(reason);
}

}  // namespace

struct ResultsFolder::Files {
  Files(MPI_Comm comm, const Case& of, const std::string& command) : directory(comm, of.input().run.directory) {
    const QuietErrors quiet;
    directory.remove_earlier_results();
    file.emplace(comm, directory / "results.h5");
    write_identity(*file, of.input(), command);
  }

  OutputDirectory directory;
  std::optional<ResultsFile> file;
  std::map<std::string, GridShape> grids;  ///< of groups with coordinates
};

ResultsFolder::ResultsFolder(MPI_Comm comm, const Case& of, const std::string& command)
    : files_(std::make_unique<Files>(comm, of, command)) {}
ResultsFolder::~ResultsFolder() = default;

void ResultsFolder::field(const std::string& group, const std::string& name, const std::string& unit, const Film& film,
                          const std::function<double(int, int)>& value) {
  const ContactFilm& of = *film.view().film;
  const QuietErrors quiet;
  const std::string path = "/" + group;
  Field<double> values(of.grid());
  require_on_all(files_->file->comm(), [&] {
    for (int i = 0; i < film.nx(); ++i) {
      for (int j = 0; j < film.rows(); ++j) values.row(i)[j] = value(i, j);
    }
  });
  const WholeDomain domain(of.grid());
  const auto [known, is_new] = files_->grids.emplace(path, of.grid().shape());
  if (is_new) files_->file->grid(path, domain, of.scales());
  if (!(known->second == of.grid().shape())) {
    throw InputError("the group '", group, "' has fields of a film with other nodes; give this field another group");
  }
  files_->file->field(path, name, unit, domain, values, 1.0, path);
}

void ResultsFolder::table(const std::string& path, const std::vector<Column>& columns,
                          const std::vector<std::vector<double>>& rows) {
  std::vector<TableColumn> all;
  all.reserve(columns.size());
  for (const Column& column : columns) all.push_back({column.name, column.unit});
  std::vector<double> values;
  const QuietErrors quiet;
  MPI_Comm comm = files_->file->comm();
  require_on_all(comm, [&] {
    for (const std::vector<double>& row : rows) {
      if (row.size() != columns.size()) {
        throw InputError("a row of the table '", path, "' has ", row.size(), " values for ", columns.size(),
                         " columns; give one for each");
      }
      values.insert(values.end(), row.begin(), row.end());
    }
  });
  unsigned long count = values.size();
  MPI_Bcast(&count, 1, MPI_UNSIGNED_LONG, 0, comm);
  values.resize(count);
  MPI_Bcast(values.data(), static_cast<int>(count), MPI_DOUBLE, 0, comm);
  write_table(*files_->file, "/" + path, all, values);
}

void ResultsFolder::finish(const Results& results) {
  const QuietErrors quiet;
  MPI_Comm comm = files_->file->comm();
  files_->file->finish();
  write_summary(comm, files_->directory.path(), results.content().summary);
}

}  // namespace gearfilm
