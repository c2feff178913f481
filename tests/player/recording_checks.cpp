#include <support/checks.hpp>
#include <support/recording.hpp>
#include <tumble/pose.hpp>

using namespace tumble;
using support::complaint_of, support::Part, support::Recording;

TEST_CASE("A recording of one turned box in two frames is this JSON") {
  Recording recording("A box", 0.5);
  const Posed lifted{.position = {0, 0, 2}, .orientation = {0, {1, 0, 0}}};
  CHECK(recording.add_body("box", {Part::box({1, 2, 3}).at(lifted)}) == 0);
  recording.add_link({.point = {0, 0, 1}, .body = 0}, {.point = {0.25, 0, 0}});
  recording.add_frame(std::array{Posed{}});
  recording.add_frame(std::array{lifted});
  CHECK(recording.json() ==
        R"({"title":"A box","seconds_between_frames":0.5,"bodies":[{"name":"box","parts":[)"
        R"({"box":[1,2,3],"position":[0,0,2],"orientation":[0,1,0,0]}]}],)"
        R"("links":[{"from":{"body":0,"point":[0,0,1]},"to":{"point":[0.25,0,0]}}],)"
        R"("frames":[[0,0,0,1,0,0,0],[0,0,2,0,1,0,0]]})"
        "\n");
  recording.follow(0);
  CHECK(recording.json().starts_with(
      R"({"title":"A box","seconds_between_frames":0.5,"follow":0,"bodies":[)"));
}

TEST_CASE("Every kind of part is written by its name") {
  CHECK(Part::sphere(0.5).json() == R"({"sphere":0.5})");
  CHECK(Part::cylinder(1, 2).json() == R"({"cylinder":[1,2]})");
  CHECK(Part::capsule(1, 2).json() == R"({"capsule":[1,2]})");
  CHECK(Part::cone(1, 2).json() == R"({"cone":[1,2]})");
  CHECK(Part::ellipsoid({1, 2, 3}).json() == R"({"ellipsoid":[1,2,3]})");
  CHECK(Part::point().json() == R"({"point":true})");
  CHECK(Part::mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}).json() ==
        R"({"mesh":{"corners":[[0,0,0],[1,0,0],[0,1,0]],"triangles":[[0,1,2]]}})");
}

TEST_CASE("Numbers have a float's digits, the time between frames all of its own") {
  Recording recording("", 1.0 / 3);
  recording.add_body("", {});
  recording.add_frame(std::array{Posed{.position = {1.0 / 3, 0, 0}}});
  CHECK(recording.json().find("\"seconds_between_frames\":0.3333333333333333,") !=
        std::string::npos);
  CHECK(recording.json().find("[0.33333334,0,0,1,0,0,0]") != std::string::npos);
}

TEST_CASE("A name may hold quotation marks, backslashes and control characters") {
  CHECK(support::json_text("a\"b\\c\n\x1f\u00fc") == "\"a\\\"b\\\\c\\u000a\\u001f\u00fc\"");
}

TEST_CASE("What can't be replayed is refused with the value, its unit and the rule") {
  const double infinity = std::numeric_limits<double>::infinity();
  CHECK(complaint_of([] { Recording("", 0); }) ==
        "time between frames is 0 s; it must be greater than 0");
  CHECK(complaint_of([&] { Recording("", infinity); }) ==
        "time between frames is inf s; it must be finite");
  CHECK(complaint_of([] { Part::sphere(-1); }) ==
        "radius of the sphere is -1 m; it must be 0 or more");
  CHECK(complaint_of([&] {
          Part::box({1, infinity, 1});
        }) == "length of the box is inf m; a recording holds finite floats only");
  CHECK(complaint_of([] {
          Part::mesh({{0, 0, 0}}, {{0, 0, 1}});
        }) == "a triangle of the mesh names corner 1; it has 1, counted from 0");

  Recording recording("", 1);
  recording.add_body("", {});
  recording.add_frame(std::array{Posed{}});
  const std::string before = recording.json();
  CHECK(complaint_of([&] {
          recording.add_frame(std::array{Posed{}, Posed{}});
        }) == "a frame with 2 poses; it must have one for each of the 1 bodies");
  // Finite as a double, and not as a float.
  CHECK(complaint_of([&] {
          recording.add_frame(std::array{Posed{.position = {0, 1e39, 0}}});
        }) == "position in a frame is 1e+39 m; a recording holds finite floats only");
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(complaint_of([&] {
          recording.add_frame(std::array{Posed{.orientation = {nan, {}}}});
        }) == "orientation in a frame is nan; a recording holds finite floats only");
  CHECK(complaint_of([&] {
          recording.add_link({.point = {0, 0, 0}, .body = 1}, {.point = {0, 0, 0}});
        }) == "a link names body 1; there are 1, counted from 0");
  CHECK(complaint_of([&] { recording.follow(1); }) ==
        "the camera is to follow body 1; there are 1, counted from 0");
  CHECK_THROWS_AS(recording.add_body("late", {}), std::logic_error);
  CHECK(recording.json() == before);
}

TEST_CASE("A recording that can't be written says where") {
  CHECK_THROWS_WITH_AS(Recording("", 1).write("no_such_folder/a.recording.json"),
                       "cannot write no_such_folder/a.recording.json", std::runtime_error);
}
