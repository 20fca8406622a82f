// Tests examples/conformal/process/Progress.cpp examples/conformal/process/Pace.cpp
// Tests examples/conformal/process/status_line.cpp examples/conformal/process/Signal_text.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "conformal/process/Progress.h"

#include "program/support.h"
#include "support/spheres.h"

#include "conformal/process/status_line.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <functional>
#include <regex>
#include <sstream>

namespace cgp_test::progress_tests {

using namespace program_test;
using conformal::Common_options;
using conformal::Progress;
using conformal::Progress_choice;

/// what is told on stderr, which is not a terminal, while a clock is set
class Progress_in_a_pipe : public ::testing::Test {
 protected:
  std::string told(const std::function<void(Progress&)>& work)
  {
    testing::internal::CaptureStderr();
    {
      Progress progress(m_options, "spin", "component 1: ", m_pace);
      work(progress);
    }
    return testing::internal::GetCapturedStderr();
  }

  double m_now = 100;
  conformal::Pace m_pace{[this] { return m_now; }};
  Common_options m_options;
};

TEST_F(Progress_in_a_pipe, is_the_status_line)
{
  const std::string all = told([](Progress& progress) {
    progress.show({"step", std::nan(""), "step 1\n of 3", 1});
    conformal::write_status();
    progress.show({"step", .255, "step 2 of 3", 2});
    progress.show({"iteration", .4256});
    conformal::write_status();
  });
  const std::string text = std::regex_replace(all, std::regex("after [0-9]+ s"), "after N s");
  const std::string first = "conformal: progress: component 1: step 1  of 3, 0 %, after N s\n";
  EXPECT_EQ(text, first + "conformal: progress: component 1: iteration, 43 %, after N s\n");
}

TEST_F(Progress_in_a_pipe, is_over_with_its_work)
{
  const auto show = [](Progress& progress) { progress.show({"step", 0}); };
  told(show);
  testing::internal::CaptureStderr();
  conformal::write_status();
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST_F(Progress_in_a_pipe, is_silent_on_request)
{
  const auto show = [](Progress& progress) {
    progress.show({"step", 0});
    conformal::write_status();
  };
  m_options.quiet = true;
  EXPECT_EQ(told(show), "");
  m_options.quiet = false;
  m_options.progress = Progress_choice::none;
  EXPECT_EQ(told(show), "");
}

TEST_F(Progress_in_a_pipe, is_an_object_of_each_stage_and_ten_a_second_for_programs)
{
  m_options.progress = Progress_choice::json;
  m_options.quiet = true;
  const std::string text = told([this](Progress& progress) {
    progress.show({"factorization", std::nan("")});
    for (int step = 1; step <= 25; ++step) {
      progress.show({"step", .04 * step, "step \"" + std::to_string(step) + "\xff\"", step});
      m_now += 1. / 64;
    }
  });
  std::istringstream lines(text);
  std::vector<nlohmann::json> objects;
  for (std::string line; std::getline(lines, line);) objects.push_back(nlohmann::json::parse(line));
  ASSERT_EQ(objects.size(), 5u) << text;
  EXPECT_EQ(objects[0], nlohmann::json({{"command", "spin"},
                                        {"stage", "factorization"},
                                        {"fraction", 0.},
                                        {"text", "component 1: factorization"},
                                        {"seconds", 0.}}));
  EXPECT_EQ(objects[1]["step"], 1);
  EXPECT_EQ(objects[2]["step"], 8);
  EXPECT_EQ(objects[2]["seconds"], .109);
  EXPECT_EQ(objects[4]["fraction"], .04 * 22);
}

TEST(Pace, of_the_run_goes_on)
{
  const double first = conformal::Pace::of_run().seconds();
  EXPECT_GE(first, 0);
  EXPECT_GE(conformal::Pace::of_run().seconds(), first);
}

using Progress_of_program = Program;

TEST_F(Progress_of_program, is_told_when_the_alarm_comes)
{
  write("a.off", off(cgp_test::bumpy_sphere(3)));
  const std::string flow = " flow a.off --steps 100000 --time-step .001 --every 1 -o b.ply";
  const Program_run r = shell(program() + flow +
                              " & while [ ! -e b_0001.ply ]; do sleep .01; done; "
                              "kill -ALRM $!; kill -INT $!; kill -TERM $!; wait $!");
  EXPECT_NE(r.err.find("conformal: progress: step "), std::string::npos) << r.err;
  EXPECT_NE(r.err.find(" of 100000, energy "), std::string::npos) << r.err;
}

TEST_F(Progress_of_program, is_json_on_stderr_of_every_long_command)
{
  write("a.off", off(cgp_test::icosphere(2)));
  write("c.off", off(cgp_test::bumpy_sphere(3)));
  write("a.csv", "0,0\n1,0\n1,1\n.2,1.5\n0,1\n");
  for (const std::string command :
       {"spin a.off --rho-expression x -o b.ply", "flow a.off --steps 2 -o b.ply",
        "spectrum a.off --count 2", "fair c.off --region-expression x-.4 -o b.ply",
        "curve a.csv --steps 2 -o b.csv"}) {
    const Program_run r = run(command + " --advanced progress=json");
    ASSERT_EQ(r.code, 0) << r.err;
    const std::string line = r.err.substr(0, r.err.find('\n'));
    const nlohmann::json object = nlohmann::json::parse(line);
    EXPECT_EQ(object["command"], command.substr(0, command.find(' ')));
    EXPECT_TRUE(object["stage"].is_string());
    EXPECT_GE(object["fraction"], 0);
    EXPECT_GE(object["seconds"], 0);
    EXPECT_EQ(run(command + " -q").err, "");
    EXPECT_EQ(run(command + " --advanced progress=none").err.find('{'), std::string::npos);
  }
  EXPECT_TRUE(fails(run("flow a.off -o b.ply --advanced progress=xml"), 2, "{auto,none,json}"));
}

}  // namespace cgp_test::progress_tests
