// Results of computations by their names, in SI, and the files summary.json and results.h5 that hold them.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "gearfilm/case.hpp"

namespace gearfilm {

/// The results of one computation under the names that summary.json has (docs/results.md, docs/guide/results.md).
class Results {
public:
  Results();

  /// Whether there is a number of that name.
  bool has(const std::string& name) const;
  /// The number of that name. Throws std::out_of_range, with the name, where there is none.
  double number(const std::string& name) const;
  /// Adds a number, or replaces the one of that name.
  void set(const std::string& name, double value);
  /// All results, nested ones too, as JSON text.
  std::string json() const;

  /// The JSON that holds the results; no part of the public interface.
  struct Content;
  explicit Results(Content content);
  const Content& content() const { return *content_; }

private:
  std::shared_ptr<const Content> content_;
};

/// The film of one contact on the nodes that this process stores: i = 0..nx-1 along X, j = 0..rows-1 across. Where the
/// film is its own mirror image in Y = 0, nodes with Y >= 0 are stored.
class Film {
public:
  int nx() const;
  int rows() const;
  double x(int i) const;                 ///< from the contact's centre [m]
  double y(int j) const;                 ///< from the contact's middle line [m]
  double pressure(int i, int j) const;   ///< [Pa]
  double thickness(int i, int j) const;  ///< [m]

  /// The film and its scales; no part of the public interface.
  struct View;
  explicit Film(std::shared_ptr<const View> view) : view_(std::move(view)) {}
  const View& view() const { return *view_; }

private:
  std::shared_ptr<const View> view_;
};

/// Writes summary.json and results.h5 into the output folder of a case (output.dir). All calls are collective. They
/// throw OutputError where files cannot be written; what one process throws, all throw.
class ResultsFolder {
public:
  /// Makes the folder and removes an earlier run's results from it. `command` is written into the files as what
  /// computed them. Throws InputError where the folder holds files that this library did not write.
  ResultsFolder(MPI_Comm comm, const Case& of, const std::string& command);
  ~ResultsFolder();
  ResultsFolder(const ResultsFolder&) = delete;
  ResultsFolder& operator=(const ResultsFolder&) = delete;

  /// Writes a field on the nodes of a film to results.h5 as GROUP/NAME, beside its coordinates. value(i, j) is in the
  /// unit given. All films of one group have the same nodes.
  void field(const std::string& group, const std::string& name, const std::string& unit, const Film& film,
             const std::function<double(int i, int j)>& value);

  struct Column {
    std::string name;
    std::string unit;  ///< "-" for pure numbers
  };
  /// Writes a table to results.h5. Each row has a value for each column; the rows of the first process are taken.
  void table(const std::string& path, const std::vector<Column>& columns, const std::vector<std::vector<double>>& rows);

  /// Writes summary.json and closes the files. Throws SolveError for a number that is not finite.
  void finish(const Results& results);

private:
  struct Files;
  std::unique_ptr<Files> files_;
};

}  // namespace gearfilm
