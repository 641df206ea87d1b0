// What a user writes, right or wrong: case files, command line, and the table of parameters behind them.
#include <gtest/gtest.h>
#include <petscsys.h>

#include <cmath>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>
#include <set>
#include <sstream>

#include "gearfilm/error.hpp"
#include "input/case.hpp"
#include "input/case_file.hpp"
#include "input/case_with_parameter.hpp"
#include "input/options.hpp"
#include "input/useful_processes.hpp"
#include "parallel/petsc.hpp"

namespace gearfilm {
namespace {

const std::string source_dir = GEARFILM_SOURCE_DIR;

CaseInput read_input(const std::string& name) { return read_case(PETSC_COMM_WORLD, source_dir + "/input/" + name); }

std::string content(const std::string& path) {
  std::ifstream stream(path);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

// Options as if given on the command line, for the time of a scope.
class CommandLine {
public:
  CommandLine(std::initializer_list<std::pair<std::string, std::string>> options) : options_(options) {
    for (const auto& [name, value] : options_) petsc_check(PetscOptionsSetValue(nullptr, name.c_str(), value.c_str()));
  }
  ~CommandLine() {
    for (const auto& [name, value] : options_) (void)PetscOptionsClearValue(nullptr, name.c_str());
  }
  CommandLine(const CommandLine&) = delete;
  CommandLine& operator=(const CommandLine&) = delete;

private:
  std::vector<std::pair<std::string, std::string>> options_;
};

template <class Action>
std::string input_error(Action action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  return "(no InputError)";
}

void expect_words(const std::string& message, const std::vector<std::string>& words) {
  for (const std::string& word : words) EXPECT_NE(message.find(word), std::string::npos) << word << " in: " << message;
}

TEST(CaseFile, barbieri_case_has_the_derived_quantities_of_table_3) {
  const nlohmann::json derived =
      nlohmann::json::parse(content(source_dir + "/tests/reference/table3.json")).at("derived");
  const auto expect = [&](const std::string& name, double value) {
    const double wanted = derived.at(name).at("value");
    EXPECT_NEAR(value, wanted, std::abs(wanted) * derived.at(name).at("rel_tol").get<double>()) << name;
  };
  const CaseInput barbieri = read_input("barbieri2013.yaml");
  EXPECT_EQ(barbieri.name, "barbieri2013");
  EXPECT_EQ(barbieri.kind, CaseKind::gear_pair);
  EXPECT_EQ(barbieri.run.directory, "output/barbieri2013");
  expect("contact_ratio", barbieri.pair.line->contact_ratio());
  expect("R_x", barbieri.scales.solids.radius_x);
  expect("R_y", barbieri.scales.solids.radius_y);
  expect("a", barbieri.scales.hertz.a);
  expect("p_hertz", barbieri.scales.hertz.pressure);
  expect("f_m", mesh_frequency(*barbieri.pair.gears, barbieri.pair.pinion_speed));
  expect("I_n", barbieri.scales.inertia(*barbieri.pair.equivalent_mass));
  const MoesGroups moes = moes_groups(barbieri.scales.solids, barbieri.scales.oil, barbieri.scales.operation);
  expect("M", moes.M);
  expect("L", moes.L);
  // M >= 200: the short domain of the paper's Table 1.
  EXPECT_EQ(barbieri.numerics.domain.x_min, -2.083);
  EXPECT_EQ(barbieri.numerics.nx, 129);
  EXPECT_EQ(barbieri.numerics.ny, 65);
}

TEST(CaseFile, wang_case_carries_the_equivalent_point_load) {
  const CaseInput wang = read_input("wang2004.yaml");
  // design values of eq. (27): 493.6 N, 0.1179 mm, 0.786 GPa, printed to that many digits.
  EXPECT_NEAR(wang.scales.operation.load, 493.6, 0.05);
  EXPECT_NEAR(wang.scales.hertz.a, 0.1179e-3, 0.5e-7);
  EXPECT_NEAR(wang.scales.hertz.pressure, 0.786e9, 0.5e6);
  EXPECT_FALSE(wang.pair.equivalent_mass.has_value());
  EXPECT_EQ(wang.numerics.domain.y_half, 3.0);
  EXPECT_EQ(wang.numerics.ny, 129);
}

TEST(CaseFile, circular_case_has_moes_groups_20_and_10) {
  const CaseInput circular = read_input("circular_m20_l10.yaml");
  EXPECT_EQ(circular.kind, CaseKind::contact);
  EXPECT_FALSE(circular.pair.gears.has_value());
  EXPECT_FALSE(circular.pair.line.has_value());
  const MoesGroups moes = moes_groups(circular.scales.solids, circular.scales.oil, circular.scales.operation);
  // Load and velocity have four digits.
  EXPECT_NEAR(moes.M, 20.0, 20.0 * 1e-3);
  EXPECT_NEAR(moes.L, 10.0, 10.0 * 1e-3);
}

TEST(CaseFile, dotted_keys_and_nested_keys_are_the_same) {
  const auto nested = parse_case_text("x.yaml", "pinion: {teeth: 28}\n");
  const auto dotted = parse_case_text("x.yaml", "\npinion.teeth: 28\n");
  ASSERT_EQ(nested.size(), 1u);
  ASSERT_EQ(dotted.size(), 1u);
  EXPECT_EQ(nested[0].name, dotted[0].name);
  EXPECT_EQ(nested[0].value, dotted[0].value);
  EXPECT_EQ(dotted[0].line, 2);
}

TEST(CaseFile, former_keys_and_options_are_read_as_the_present_ones) {
  const auto entries = parse_case_text("x.yaml", "lubricant: {doolittle_occupied: 0.6}\n");
  ASSERT_EQ(entries.size(), 1u);
  EXPECT_EQ(entries[0].name, "lubricant.doolittle_r0");
  expect_words(input_error([] { parse_case_text("x.yaml", "lubricant:\n  tait_slope: 11\n  tait_k0_prime: 12\n"); }),
               {"x.yaml:3: duplicate key 'lubricant.tait_k0_prime' (formerly 'lubricant.tait_slope')", "line 2"});
  const CommandLine options{{"-lubricant_tait_slope", "9"}, {"-lubricant_tait_beta_k", "0.02"}};
  const ParameterValues values = read_input("squalane.yaml").parameters;
  EXPECT_EQ(values.real("lubricant.tait_k0_prime"), 9.0);
  EXPECT_EQ(values.origin("lubricant.tait_k0_prime"), "option -lubricant_tait_slope");
  EXPECT_EQ(values.real("lubricant.tait_beta_k"), 0.02);
  EXPECT_NO_THROW(require_single_options({"-lubricant_tait_slope", "9"}));
  expect_words(input_error([] {
                 require_single_options({"-lubricant_tait_slope", "9", "-Lubricant_tait_k0_prime"});
               }),
               {"'-lubricant_tait_k0_prime' (formerly '-lubricant_tait_slope') is given twice"});
}

TEST(CaseFile, name_of_the_file_is_the_default_name) {
  ParameterValues values("input/some_case.yaml");
  for (const CaseFileEntry& entry : parse_case_text("x", content(source_dir + "/input/circular_m20_l10.yaml")))
    if (entry.name != "case.name") values.set(entry.name, entry.value, "x");
  values.complete();
  EXPECT_EQ(make_case(values).name, "some_case");
  EXPECT_EQ(make_case(values).run.directory, "output/some_case");
}

TEST(CommandLine, overrides_the_file_and_leaves_nothing_to_the_next_case) {
  {
    const CommandLine options{{"-grid_nx", "65"}, {"-pinion_speed_rpm", "8000"}, {"-steady_position", "-1e-3"}};
    const CaseInput overridden = read_input("barbieri2013.yaml");
    EXPECT_EQ(overridden.numerics.nx, 65);
    EXPECT_DOUBLE_EQ(overridden.pair.pinion_speed, 8000 * 2 * std::numbers::pi / 60);
    EXPECT_DOUBLE_EQ(overridden.steady.position, -1e-3);
  }
  EXPECT_EQ(read_input("barbieri2013.yaml").numerics.nx, 129);
  // These two have a grid section, Barbieri's has none.
  EXPECT_EQ(read_input("wang2004.yaml").numerics.ny, 129);
  EXPECT_EQ(read_input("circular_m20_l10.yaml").numerics.nx, 65);
  EXPECT_EQ(read_input("barbieri2013.yaml").numerics.nx, 129);
  {
    const CommandLine same_as_the_file_before{{"-grid_nx", "65"}};
    EXPECT_EQ(read_input("circular_m20_l10.yaml").numerics.nx, 65);
    EXPECT_EQ(read_input("barbieri2013.yaml").numerics.nx, 65);
  }
}

TEST(Defaults, time_steps_are_solved_the_further_the_thinner_films_are) {
  const auto tolerance = [] { return read_input("barbieri2013.yaml").numerics.steps.newton.tolerance; };
  // h = 2.7018 um, R_x = 11.468 mm and a = 0.56669 mm, as `info` prints them: H = 0.09648.
  EXPECT_NEAR(tolerance(), 6e-5 * 0.09648, 1e-3 * tolerance());
  {
    const CommandLine thick{{"-lubricant_viscosity", "0.5"}};
    EXPECT_EQ(tolerance(), 1e-5);
  }
  const CommandLine given{{"-time_newton_tolerance", "1e-4"}};
  EXPECT_EQ(tolerance(), 1e-4);
}

TEST(CommandLine, is_checked_like_the_file) {
  const auto error_with = [](const std::string& option, const std::string& value) {
    const CommandLine options{{option, value}};
    return input_error([&] {
      require_known_options({option, value});
      read_input("barbieri2013.yaml");
    });
  };
  expect_words(error_with("-grid_nx", "64"), {"option -grid_nx", "64", "odd whole number", "17"});
  expect_words(error_with("-grid_nx", "65.5"), {"option -grid_nx", "65.5", "whole number"});
  expect_words(error_with("-grid_nx", ""), {"option -grid_nx", "no value"});
  expect_words(error_with("-pinion_torque", "nan"), {"option -pinion_torque", "nan", "[1e-6, 1e9]"});
  expect_words(error_with("-solver_precision", "half"), {"option -solver_precision", "half", "single, double"});
  expect_words(error_with("-grid_nz", "65"), {"unknown option '-grid_nz 65'", "did you mean '-grid_nx'"});
  expect_words(error_with("-nx", "65"), {"unknown option '-nx 65'", "did you mean '-grid_nx'"});
  expect_words(error_with("--grid_nx", "65"), {"unknown option", "did you mean '-grid_nx'"});
  expect_words(error_with("-grid_nx=65", ""),
               {"unknown option '-grid_nx=65'", "did you mean '-grid_nx 65', with a blank"});
  expect_words(error_with("-GRID_nz=65", "-grid_ny"), {"'-GRID_nz=65 -grid_ny'", "did you mean '-grid_nx 65'"});
  expect_words(error_with("-ksp_rtol=1e-3", ""), {"did you mean '-ksp_rtol 1e-3'"});
  expect_words(error_with("-sweep_values=1, 2", ""), {"did you mean '-sweep_values \"1, 2\"'"});
  expect_words(error_with("-no_grid_nx", ""), {"unknown option '-no_grid_nx'"});
  expect_words(error_with("-contact_load", "10"), {"option -contact_load", "case.kind: contact", "gear_pair"});
  EXPECT_EQ(input_error([] { read_input("barbieri2013.yaml"); }), "(no InputError)");
}

TEST(CommandLine, unknown_options_that_nobody_typed_are_reported_and_no_errors) {
  const CommandLine options{{"-hdf5_compress", ""}};
  require_known_options({"-grid_nx", "65"});
  EXPECT_EQ(unused_options(), std::vector<std::string>{"-hdf5_compress"});
}

TEST(CommandLine, petsc_options_pass_and_are_reported_when_unused) {
  const CommandLine options{{"-ksp_tpye", "cg"}, {"-log_view", ":/dev/null"}, {"-options_left", ""}};
  EXPECT_NO_THROW(read_input("barbieri2013.yaml"));
  const std::vector<std::string> unused = unused_options();
  ASSERT_EQ(unused.size(), 1u);
  EXPECT_EQ(unused.front(), "-ksp_tpye cg");
}

TEST(UsefulProcesses, have_eight_rows_and_4096_points_each) {
  const auto useful = [](int nx, int ny, int heated_points, int present) {
    return useful_processes(rectangle(nx, ny, -2.5, 1.5, 2.0), heated_points, present);
  };
  EXPECT_EQ(useful(129, 65, 0, 64), 1);
  EXPECT_EQ(useful(129, 129, 0, 64), 2);
  EXPECT_EQ(useful(129, 65, 16, 64), 4) << "by rows";
  EXPECT_EQ(useful(257, 257, 0, 64), 8);
  EXPECT_EQ(useful(257, 257, 0, 2), 2);
  EXPECT_EQ(useful(17, 9, 0, 2), 1);
}

TEST(BadInput, yaml_beyond_keys_and_values_is_refused) {
  const auto error_of = [](const std::string& text) { return input_error([&] { parse_case_text("x.yaml", text); }); };
  expect_words(error_of("just text"), {"x.yaml:1", "'just text'"});
  expect_words(error_of("- 1\n- 2\n"), {"x.yaml:1", "list"});
  expect_words(error_of("pinion: 5\n"), {"'pinion' is a section"});
  expect_words(error_of("pinion:\ngrid: {nx: 65}\n"), {"section 'pinion' is empty"});
  expect_words(error_of("pinoin:\n"), {"unknown key 'pinoin'"});
  expect_words(error_of("grid: {nx: &n 65, ny: *n}\n"), {"YAML anchors"});
  expect_words(error_of("grid: {nx: 65}\n---\ngrid: {ny: 65}\n"), {"x.yaml:2", "second YAML document"});
  expect_words(error_of("grid: {nx: 65}\ngrid.nx: 33\n"), {"x.yaml:2", "duplicate key 'grid.nx'"});
  expect_words(error_of("nx: 65\n"), {"unknown key 'nx'", "did you mean 'grid.nx'"});
  expect_words(error_of("grid: {nx: {a: 1}}\n"), {"unknown key 'grid.nx.a'"});
  expect_words(error_of("a: {b: {c: {d: 1}}}\n"), {"nested too deeply"});
  expect_words(error_of("grid: {nx: !!int 65}\n"), {"YAML tags"});
  expect_words(error_of("? {a: 1}\n: 2\n"), {"x.yaml:1"});
  expect_words(error_of("grid: {nx: 65\n"), {"malformed YAML"});
  expect_words(error_of("output: {dir: x}\n  grid: {nx: 65}\n"), {"malformed YAML"});
  expect_words(error_of("case.name: 'x\ngrid: {nx: 65}\n"), {"malformed YAML", "quote"});
  expect_words(error_of("case.name: \"x"), {"malformed YAML", "quote"});
  expect_words(error_of("grid:\n\tnx: 65\n"), {"x.yaml:2", "malformed YAML", "tab"});
}

TEST(CaseFile, comments_quotes_and_document_marks_are_allowed) {
  const auto entries =
      parse_case_text("x.yaml", "%YAML 1.2\n---\n# it's \"odd\n\ngrid: {nx: '65'}  # \"\n...\n# end\n");
  ASSERT_EQ(entries.size(), 1u);
  EXPECT_EQ(entries[0].value, "65");
  EXPECT_EQ(entries[0].line, 5);
  EXPECT_TRUE(parse_case_text("x.yaml", "").empty());
  EXPECT_TRUE(parse_case_text("x.yaml", "# nothing").empty());
}

TEST(BadInput, a_directory_is_not_a_case) {
  expect_words(input_error([] { read_case(PETSC_COMM_WORLD, source_dir + "/input"); }), {"is a directory"});
}

TEST(Parameters, names_and_options_are_unique_and_not_petsc_ones) {
  std::set<std::string> options;
  for (const Parameter& parameter : parameter_table()) {
    EXPECT_TRUE(options.insert(parameter.option()).second) << parameter.name;
    EXPECT_FALSE(is_petsc_option(parameter.option())) << parameter.name;
    EXPECT_FALSE(parameter.meaning.empty()) << parameter.name;
  }
}

TEST(Parameters, defaults_are_allowed_values) {
  for (const Parameter& parameter : parameter_table()) {
    if (parameter.presence != Presence::preset) continue;
    EXPECT_NO_THROW(parse_value(parameter, parameter.fallback, "default")) << parameter.name;
  }
}

TEST(Parameters, open_ends_exclude_and_closed_ends_include) {
  const Parameter& edge = *find_parameter("grid.x_max");  // (1, 100]
  EXPECT_THROW(parse_value(edge, "1", "x"), InputError);
  EXPECT_NO_THROW(parse_value(edge, "1.0000001", "x"));
  const Parameter& module = *find_parameter("gear.module");  // [1e-5, 0.1]
  EXPECT_NO_THROW(parse_value(module, "1e-5", "x"));
  EXPECT_NO_THROW(parse_value(module, "0.1", "x"));
  EXPECT_THROW(parse_value(module, "0.1000001", "x"), InputError);
  EXPECT_NO_THROW(parse_value(*find_parameter("grid.nx"), "17", "x"));
  EXPECT_THROW(parse_value(*find_parameter("grid.nx"), "15", "x"), InputError);
  for (const std::string text : {"inf", "nan", "1e999", "3 mm", "3mm", "0x1", "1d-3", ".", "1,5"})
    EXPECT_THROW(parse_value(module, text, "x"), InputError) << text;
  EXPECT_EQ(std::get<double>(parse_value(module, "+5E-3", "x")), 5e-3);
}

TEST(Parameters, yes_and_no_may_be_written_as_yaml_libraries_write_them) {
  int counted = 0;
  for (const Parameter& parameter : parameter_table()) {
    if (!parameter.is_yes_or_no()) continue;
    ++counted;
    for (const std::string yes : {"yes", "Yes", "true", "True", "TRUE"})
      EXPECT_EQ(std::get<std::string>(parse_value(parameter, yes, "x")), "yes") << parameter.name << ": " << yes;
    for (const std::string no : {"no", "No", "false", "False", "FALSE"})
      EXPECT_EQ(std::get<std::string>(parse_value(parameter, no, "x")), "no") << parameter.name << ": " << no;
    for (const std::string neither : {"on", "1", "y", "truely", "none"})
      EXPECT_THROW(parse_value(parameter, neither, "x"), InputError) << parameter.name << ": " << neither;
  }
  EXPECT_GE(counted, 8);
  const Parameter& name = *find_parameter("case.name");
  EXPECT_EQ(std::get<std::string>(parse_value(name, "true", "x")), "true");
  EXPECT_THROW(parse_value(*find_parameter("model"), "true", "x"), InputError);
}

TEST(Parameters, true_and_false_are_echoed_as_yes_and_no) {
  const CommandLine options{{"-keep_checkpoint", "true"}, {"-periodic_multipliers", "false"}};
  const CaseInput given = read_input("barbieri2013.yaml");
  EXPECT_TRUE(given.run.keep_checkpoint);
  EXPECT_FALSE(given.search.with_multipliers);
  std::map<std::string, std::string> echoed;
  for (const EchoedValue& value : given.parameters.echo()) echoed[value.name] = value.value;
  EXPECT_EQ(echoed.at("keep_checkpoint"), "yes");
  EXPECT_EQ(echoed.at("periodic.multipliers"), "no");
}

TEST(Parameters, echo_reads_back_as_the_same_case) {
  const CaseInput original = read_input("wang2004.yaml");
  ParameterValues again("echo");
  for (const EchoedValue& echoed : original.parameters.echo()) again.set(echoed.name, echoed.value, "echo");
  again.complete();
  const CaseInput repeated = make_case(again);
  EXPECT_EQ(repeated.name, original.name);
  EXPECT_EQ(repeated.scales.operation.load, original.scales.operation.load);
  EXPECT_EQ(repeated.scales.lambda, original.scales.lambda);
  EXPECT_EQ(repeated.numerics.solver.newton.tolerance, original.numerics.solver.newton.tolerance);
  EXPECT_EQ(repeated.parameters.echo().size(), original.parameters.echo().size());
}

TEST(FaceRows, are_a_tenth_of_the_contact_apart_by_default_and_less_where_more_accuracy_is_asked_for) {
  const auto largest = [](const CaseInput& input) { return input.numerics.face_rows.value().largest; };
  const CaseInput input = read_input("fzg_a.yaml");
  const double contact = 1.0 / input.scales.hertz.ellipticity;
  EXPECT_DOUBLE_EQ(largest(input), 0.1 * contact);
  {
    const CommandLine options{{"-grid_accuracy", "0.005"}};
    EXPECT_DOUBLE_EQ(largest(read_input("fzg_a.yaml")), 0.05 * contact);
  }
  {
    const CommandLine options{{"-grid_accuracy", "0.1"}};
    ASSERT_GT(contact, 25.0);
    EXPECT_DOUBLE_EQ(largest(read_input("fzg_a.yaml")), 0.1 * contact);
  }
  {
    const CommandLine crowned{{"-pinion_crowning", "60e-6"}};
    const double ellipse = read_input("fzg_a.yaml").scales.hertz.b;
    const CommandLine whole{{"-grid_whole_face", "yes"}};
    EXPECT_NEAR(largest(read_input("fzg_a.yaml")), 0.1 * ellipse / input.scales.length, 1e-12);
  }
  {
    const CommandLine options{{"-pinion_crowning", "200e-6"}, {"-grid_whole_face", "yes"}};
    EXPECT_EQ(largest(read_input("fzg_a.yaml")), 2.5);
  }
  {
    const CommandLine options{{"-pinion_crowning", "1e-9"}, {"-grid_whole_face", "yes"}};
    EXPECT_DOUBLE_EQ(largest(read_input("fzg_a.yaml")), 0.1 * contact) << "too straight for an ellipse";
  }
  const CommandLine options{{"-grid_largest_row", "7"}};
  EXPECT_EQ(largest(read_input("fzg_a.yaml")), 7.0);
}

// Of a whole face it takes a second. The static force changes it, the speed does not.
TEST(FaceLaws, are_made_once_for_all_cases_of_a_pair) {
  const CaseInput pair = read_input("misaligned.yaml");
  const auto law_at = [&](const char* parameter, double value) {
    return case_with_parameter(pair, parameter, value).scales.face_law;
  };
  EXPECT_EQ(law_at("pinion.speed_rpm", 2000.0), pair.scales.face_law);
  const std::shared_ptr<const FaceLaw> other = law_at("pinion.torque", 300.0);
  EXPECT_NE(other, pair.scales.face_law);
  EXPECT_EQ(law_at("pinion.torque", 300.0), other);
  EXPECT_EQ(law_at("pinion.speed_rpm", 2300.0), pair.scales.face_law);
}

TEST(Parameters, help_names_every_option) {
  const std::string help = parameter_help();
  for (const Parameter& parameter : parameter_table()) expect_words(help, {parameter.option() + " "});
}

TEST(Parameters, page_in_the_manual_is_the_generated_one) {
  EXPECT_EQ(content(source_dir + "/docs/parameters.md"), parameter_markdown())
      << "write docs/parameters.md again with `gearfilm parameters`";
}

}  // namespace
}  // namespace gearfilm
