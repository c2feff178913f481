/// @file
/// Scene files with one mistake each, and the sentence that each must get.
#pragma once

#include <string>
#include <vector>

namespace tumble::support {

/// A scene with these bodies and effects.
inline std::string scene_of(const std::string& bodies, const std::string& effects = "",
                            const std::string& more = "") {
  return R"({"title": "a", "description": "b", "duration": 1, )" + more + R"("bodies": [)" +
         bodies + R"(], "effects": [)" + effects + "]}";
}

/// A ball called "ball" and a point called "drop", whose numbers are sound.
inline const std::string ball =
    R"({"name": "ball", "solid": {"shape": "sphere", "radius": 0.1}, "density": 700})";
inline const std::string drop = R"({"name": "drop", "mass": 2})";

/// The ball with more keys, the drop with more keys, and a body with a solid of 1 kg.
inline std::string ball_with(const std::string& more) {
  return R"({"name": "ball", "solid": {"shape": "sphere", "radius": 0.1}, "density": 700, )" +
         more + "}";
}
inline std::string drop_with(const std::string& more) {
  return R"({"name": "drop", "mass": 2, )" + more + "}";
}
inline std::string with_solid(const std::string& solid) {
  return R"({"name": "thing", "mass": 1, "solid": )" + solid + "}";
}
inline std::string effect(const std::string& kind, const std::string& more) {
  return R"({"kind": ")" + kind + R"(", )" + more + "}";
}

struct BadScene {
  std::string text;
  std::string complaint;  ///< what follows "bad.json: ", without the JSON parser's own words
};

inline std::vector<BadScene> bad_scenes() {
  const std::string one = ball + ", " + drop;
  const auto body = [](const std::string& text, const std::string& complaint) {
    return BadScene{scene_of(text), complaint};
  };
  const auto on_both = [&](const std::string& text, const std::string& complaint) {
    return BadScene{scene_of(one, text), complaint};
  };
  const auto whole = [&](const std::string& more, const std::string& complaint) {
    return BadScene{scene_of(one, "", more), complaint};
  };
  std::string deep;
  for (int n = 0; n < 40; ++n) deep += "[";
  return {
      // Not JSON, or not a scene.
      {"", "line 1, column 1: not valid JSON"},
      {"{\n  \"title\": }", "line 2, column 12: not valid JSON"},
      {"{\n  \"title\": \"a\nb\"}", "line 2, column 14: not valid JSON"},
      {"{\"title\": \"a\\u001b[2J\", \"duration\": 1, \"bodies\": [" + drop + "]}",
       R"(/title is "a\u001b[2J"; a text holds no control characters but line ends and tabs)"},
      {"{\"title\": \"a\u202e\", \"duration\": 1, \"bodies\": [" + drop + "]}",
       R"(/title is "a\u202e"; a text holds no control characters but line ends and tabs)"},
      {"{\"a\\u001b\\u009b\": 1, \"duration\": 1, \"bodies\": [" + drop + "]}",
       R"(/a\u001b\u009b is no key of a scene)"},
      {R"({"title": "a", "duration": 1e999})", "/duration is 1e999; no number can be that large"},
      {R"({"bodies": [1, 2, 1e999]})", "/bodies/2 is 1e999; no number can be that large"},
      {R"({"duration": NaN})", "line 1, column 14: not valid JSON"},
      {R"({"duration": 1)", "line 1, column 15: not valid JSON"},
      {R"({"title": "a", "title": "b"})", "/title stands there twice; a key must be one"},
      {R"({"bodies": [{"name": "a", "name": "b"}]})",
       "/bodies/0/name stands there twice; a key must be one"},
      {deep,
       "/0/0/0/0/0/0/0/0/0/0/0/0/0/0/0/0/0/0/0/0/0/0/0/0/0/0/0/0/0/0/0 is nested more than 32 "
       "levels deep"},
      {"[]", "is []; it must be an object: a scene"},
      {"{}", "needs the keys duration, in s; bodies"},
      whole(R"("gravity": 9.81, )", "/gravity is no key of a scene"),
      whole(R"("efects": [], )", "/efects is no key of a scene; did you mean effects?"),
      whole(R"("a/b~c": 1, )", "/a~1b~0c is no key of a scene"),
      {R"({"title": 3, "description": "", "duration": 1, "bodies": []})",
       "/title is 3; it must be a text"},
      {R"({"title": "", "description": "", "duration": 0, "bodies": []})",
       "/duration is 0 s; it must be greater than 0"},
      {R"({"title": "", "description": "", "duration": 2e9, "bodies": []})",
       "/duration is 2000000000.0 s; at most 1e+09 s are simulated"},
      {R"({"title": "", "description": "", "duration": "3 s", "bodies": []})",
       "/duration is \"3 s\"; it must be a number, in s"},
      {R"({"title": "", "description": "", "duration": 1, "bodies": {}})",
       "/bodies is {}; it must be a list of bodies"},
      {R"({"title": "", "description": "", "duration": 1, "bodies": []})",
       "/bodies is []; it must have at least one element: a list of bodies"},
      whole(R"("step": 60, )", "/step is 60; it must be an object: a step"),
      whole(R"("step": {}, )", "/step needs either per_second or nanoseconds"),
      whole(R"("step": {"per_second": 60, "nanoseconds": 5000}, )",
            "/step needs either per_second or nanoseconds, not both"),
      whole(R"("step": {"per_second": 0}, )",
            "/step/per_second is 0 1/s; it must be a whole number from 1 to 1000000"),
      whole(R"("step": {"per_second": 59.94}, )",
            "/step/per_second is 59.94 1/s; it must be a whole number from 1 to 1000000"),
      whole(R"("step": {"nanoseconds": -5}, )",
            "/step/nanoseconds is -5 ns; it must be a whole number from 1000 to 3600000000000"),
      whole(R"("step": {"nanoseconds": 18446744073709551615}, )",
            "/step/nanoseconds is 18446744073709551615 ns; it must be a whole number from 1000 to "
            "3600000000000"),
      whole(R"("turning_method": "spliting", )",
            "/turning_method is \"spliting\"; no method has that name; did you mean splitting?"),
      whole(R"("turning_method": "magic", )",
            "/turning_method is \"magic\"; no method has that name; there are splitting, "
            "splitting_without_sine, axis_by_axis, carrying_momentum, implicit_newton, "
            "restoring_momentum, "
            "explicit_euler, steady"),
      whole(R"("scheme": "velvet", )",
            "/scheme is \"velvet\"; no scheme has that name; did you mean verlet?"),
      whole(R"("scheme": 2, )", "/scheme is 2; it must be a text"),
      // Bodies.
      body("3", "/bodies/0 is 3; it must be an object: a body"),
      body(R"({"mass": 1})", "/bodies/0 needs the key name"),
      body(R"({"name": "", "mass": 1})", "/bodies/0/name is \"\"; a name must have 1 to 200 bytes"),
      body(ball + ", " + ball,
           "/bodies/1/name is \"ball\"; another body has that name, and names must differ"),
      body(drop_with(R"("many": {"count": 2, "seed": 1})") + R"(, {"name": "drop 2", "mass": 1})",
           "/bodies/1 is refused: two bodies are called 'drop 2'; names must differ"),
      body(one + R"(, {"name": "x"})", "/bodies/2 needs the key mass, in kg"),
      body(R"({"name": "x", "mas": 1})", "/bodies/0/mas is no key of a body; did you mean mass?"),
      body(one + R"(, {"name": "x", "mass": -2})",
           "/bodies/2/mass is -2 kg; it must be greater than 0"),
      body(R"({"name": "x", "mass": 0})", "/bodies/0/mass is 0 kg; it must be greater than 0"),
      body(R"({"name": "x", "mass": "2 kg"})",
           "/bodies/0/mass is \"2 kg\"; it must be a number, in kg"),
      body(R"({"name": "x", "mass": "NaN"})",
           "/bodies/0/mass is \"NaN\"; it must be a number, in kg"),
      body(R"({"name": "x", "mass": null})", "/bodies/0/mass is null; it must be a number, in kg"),
      body(R"({"name": "x", "mass": 1e-320})",
           "/bodies/0/mass is 1e-320 kg; it does not fit a double, whose smallest number is "
           "2.2250738585072014e-308"),
      body(R"({"name": "x", "mass": 1.7e308})",
           "/bodies/0 is refused: mass is 1.7e+308 kg; it must lie between "
           "2.2250738585072014e-308 and "
           "4.49423283715579e+307 kg"),
      body(drop_with(R"("position": [1, 2])"),
           "/bodies/0/position is [1,2]; it must be a list of three numbers, in m"),
      body(drop_with(R"("position": [1, 2, "up"])"),
           "/bodies/0/position/2 is \"up\"; it must be a number, in m"),
      body(drop_with(R"("position": [0, 1e308, 0])"),
           "/bodies/0/position/1 is 1e+308 m; it must lie between -1e+150 and 1e+150, so that its "
           "square fits a double"),
      body(drop_with(R"("velocity": [0, 0, 1e200])"),
           "/bodies/0/velocity/2 is 1e+200 m/s; it must lie between -1e+150 and 1e+150, so that "
           "its square fits a double"),
      body(drop_with(R"("orientation": [1, 0, 0, 0])"),
           "/bodies/0/orientation is [1,0,0,0]; a point has none; give the body a solid or an "
           "inertia"),
      body(drop_with(R"("density": 3)"),
           "/bodies/0/density is 3 kg/m^3; a point has none; give the body a solid or an inertia"),
      body(ball_with(R"("mass": 3)"), "/bodies/0 needs either mass or density, not both"),
      body(R"({"name": "x", "solid": {"shape": "sphere", "radius": 1}})",
           "/bodies/0 needs either mass or density"),
      body(R"({"name": "x", "solid": {"shape": "sphere", "radius": 1}, "density": -1})",
           "/bodies/0/density is -1 kg/m^3; it must be greater than 0"),
      body(ball_with(R"("inertia": [1, 1, 1])"),
           "/bodies/0/inertia is [1,1,1]; the solid says it already"),
      body(ball_with(R"("orientation": [0, 0, 0, 0])"),
           "/bodies/0/orientation is refused: it is (0, 0, 0, 0); zero turns nothing into "
           "nothing: no turn "
           "is (1, 0, 0, 0)"),
      body(ball_with(R"("orientation": [1, 1, 0, 0])"),
           "/bodies/0/orientation is refused: it is (1, 1, 0, 0); its norm is "
           "1.4142135623730951 and must be "
           "1 within 0.01"),
      body(ball_with(R"("orientation": [1, 0, 0])"),
           "/bodies/0/orientation is [1,0,0]; it must be a quaternion, four numbers with the real "
           "part first, or an object with axis and angle"),
      body(ball_with(R"("orientation": {"axis": [0, 0, 0], "angle": 1})"),
           "/bodies/0/orientation is refused: axis is (0, 0, 0); it needs a direction"),
      body(ball_with(R"("orientation": {"axis": [0, 0, 1], "degrees": 1})"),
           "/bodies/0/orientation/degrees is no key of an axis_angle"),
      body(ball_with(R"("static": true)"),
           "/bodies/0/density is 700 kg/m^3; nothing can move a static body, so it has none"),
      body(R"({"name": "x", "static": true, "velocity": [1, 0, 0]})",
           "/bodies/0/velocity is [1,0,0]; nothing can move a static body, so it has none"),
      body(R"({"name": "x", "static": "yes"})",
           "/bodies/0/static is \"yes\"; it must be true or false"),
      body(ball_with(R"("turning": "fre")"),
           "/bodies/0/turning is \"fre\"; no way of turning has that name; did you mean free?"),
      body(R"({"name": "x", "mass": 1, "inertia": [1, 1, 3]})",
           "/bodies/0 is refused: x: the principal moments are (1, 1, 3) kg m^2; no real body has "
           "these: the two "
           "smaller must add up to the largest or more, but I_1 + I_2 = 2 < I_3 = 3"),
      body(R"({"name": "x", "mass": 1, "inertia": [-1, 1, 1]})",
           "/bodies/0 is refused: x: the principal moments are (-1, 1, 1) kg m^2; none can be "
           "negative"),
      body(R"({"name": "x", "mass": 1, "inertia": [0, 1, 1]})",
           "/bodies/0 is refused: x: the principal moments are (0, 1, 1) kg m^2; the first is "
           "zero as far as "
           "rounding can tell, and zero has no inverse; give the body some thickness"),
      body(R"({"name": "x", "mass": 1, "inertia": [[2, 1, 0], [0, 2, 0], [0, 0, 2]]})",
           "/bodies/0 is refused: x: I_xy is 1 and I_yx is 0 kg m^2; an inertia tensor is "
           "symmetric: they must be equal"),
      body(R"({"name": "x", "mass": 1, "inertia": 3})",
           "/bodies/0/inertia is 3 kg m^2; it must be a list of three moments, or of three rows of "
           "three numbers, in kg m^2"),
      body(R"({"name": "x", "inertia": [1, 1, 1]})", "/bodies/0 needs the key mass, in kg"),
      // Solids.
      body(with_solid(R"({"shape": "spere", "radius": 1})"),
           "/bodies/0/solid/shape is \"spere\"; no solid has that name; did you mean sphere?"),
      body(with_solid(R"({"radius": 1})"),
           "/bodies/0/solid needs the key shape: which solid is it?"),
      body(with_solid(R"({"shape": "sphere"})"), "/bodies/0/solid needs the key radius, in m"),
      body(with_solid(R"({"shape": "sphere", "radius": 0})"),
           "/bodies/0/solid/radius is 0 m; it must be greater than 0"),
      body(with_solid(R"({"shape": "box", "size": [1, -1, 1]})"),
           "/bodies/0/solid/size/1 is -1 m; it must be greater than 0"),
      body(with_solid(R"({"shape": "box", "radius": 1})"),
           "/bodies/0/solid/radius is no key of a box"),
      body(with_solid(R"({"shape": "spherical_shell", "inner_radius": 2, "outer_radius": 1})"),
           "/bodies/0/solid is refused: inner radius of the shell is 2 m; it must be less than "
           "the outer "
           "radius, 1 m"),
      body(R"({"name": "x", "density": 1, "solid": {"shape": "thin_rod", "length": 1}})",
           "/bodies/0/density is 1 kg/m^3; a thin_rod has no volume: give its mass"),
      body(with_solid(R"({"shape": "thin_rod", "length": 1})"),
           "/bodies/0 is refused: thing: the principal moments are (0, 0.08333333333333333, "
           "0.08333333333333333) kg m^2; the first is zero as far as rounding can tell, and zero "
           "has no inverse; give the body some thickness"),
      body(with_solid(R"({"shape": "mesh", "corners": [[0,0,0],[1,0,0],[0,1,0],[0,0,1]],)"
                      R"( "triangles": [[0,2,1],[0,1,3],[0,3,2]]})"),
           "/bodies/0/solid is refused: the edge from vertex 1 to vertex 2 belongs to triangle "
           "0 alone; the "
           "mesh is open there: close the hole, or merge vertices that lie in the same place"),
      body(with_solid(R"({"shape": "mesh", "corners": [[0,0,0],[1,0,0],[0,1,0]],)"
                      R"( "triangles": [[0,2,3]]})"),
           "/bodies/0/solid/triangles/0/2 is 3; it must be a whole number from 0 to 2"),
      body(R"({"name": "x", "mass": 1, "solid": {"shape": "compound", "parts": [)" + ball + "]}}",
           "/bodies/0/mass is 1 kg; each part of a compound has its own"),
      body(R"({"name": "x", "solid": {"shape": "compound", "parts": []}})",
           "/bodies/0/solid/parts is []; it must have at least one element: a list of parts"),
      body(R"({"name": "x", "solid": {"shape": "compound", "parts": [{"mass": 1, "solid": )"
           R"({"shape": "compound", "parts": [1]}}]}})",
           "/bodies/0/solid/parts/0/solid/shape is \"compound\"; a part can't have parts of its "
           "own"),
      // Many bodies.
      body(drop_with(R"("many": {"count": 6000000, "seed": 1})"),
           "/bodies/0/many/count is 6000000; it must be a whole number from 1 to 5000000"),
      body(drop_with(R"("many": {"count": 1})"), "/bodies/0/many needs the key seed"),
      body(drop_with(R"("many": {"count": 1, "seed": -1})"),
           "/bodies/0/many/seed is -1; it must be a whole number from 0 to 9007199254740992"),
      body(drop_with(R"("many": {"count": 1, "seed": 1, "orientation_random": true})"),
           "/bodies/0/many/orientation_random is true; a point has none"),
      body(drop_with(R"("position": [0, 0, 0], "many": {"count": 1, "seed": 1, )"
                     R"("position_between": [[0, 0, 0], [1, 1, 1]]})"),
           "/bodies/0/position is [0,0,0]; many says already what it is between"),
      body(drop_with(R"("many": {"count": 1, "seed": 1, "velocity_between": [[0, 0, 0]]})"),
           "/bodies/0/many/velocity_between is [[0,0,0]]; it must be a list of two corners, the "
           "smaller and the larger numbers"),
      // Effects.
      on_both("3", "/effects/0 is 3; it must be an object: an effect"),
      on_both("{}", "/effects/0 needs the key kind: which effect is it?"),
      on_both(R"({"kind": "gravty"})",
              "/effects/0/kind is \"gravty\"; no effect has that name; did you mean gravity?"),
      on_both(effect("gravity", R"("acceleration": 9.81)"),
              "/effects/0/acceleration is 9.81 m/s^2; it must be a list of three numbers, in "
              "m/s^2"),
      on_both(effect("gravity", R"("aceleration": [0, 0, 1])"),
              "/effects/0/aceleration is no key of a gravity; did you mean acceleration?"),
      on_both(effect("linear_damping", R"("rate": -1)"),
              "/effects/0/rate is -1 1/s; it must be 0 or more"),
      on_both(effect("point_gravity", R"("strength": -1)"),
              "/effects/0/strength is -1 m^3/s^2; it must be 0 or more"),
      on_both(effect("quadratic_drag", R"("coefficient": -1)"),
              "/effects/0/coefficient is -1 kg/m; it must be 0 or more"),
      on_both(effect("linear_damping", R"("rate": 1, "bodies": [])"),
              "/effects/0/bodies is []; it must have at least one element: a list of names of "
              "bodies"),
      on_both(effect("linear_damping", R"("rate": 1, "bodies": "drop")"),
              "/effects/0/bodies is \"drop\"; it must be a list of names of bodies"),
      on_both(effect("linear_damping", R"("rate": 1, "bodies": ["drop", "drp"])"),
              "/effects/0/bodies/1 is \"drp\"; no body has that name; did you mean drop?"),
      on_both(effect("linear_damping", R"("rate": 1, "bodies": ["drop", "drop"])"),
              "/effects/0/bodies/1 is \"drop\"; 'drop' is in the list twice"),
      on_both(effect("angular_damping", R"("rate": 1, "bodies": ["drop"])"),
              "/effects/0 is refused: 'angular damping' needs an orientation, and 'drop' is a "
              "point"),
      on_both(effect("spring", R"("bodies": ["ball"], "anchor": [0, 0, 0], "stiffness": -5)"),
              "/effects/0/stiffness is -5 N/m; it must be 0 or more"),
      on_both(effect("spring", R"("bodies": ["drop"], "anchor": [0, 0, 0], "stiffness": 5,)"
                               R"( "attachment": [1, 0, 0])"),
              "/effects/0 is refused: 'spring' needs an orientation, and 'drop' is a point"),
      on_both(effect("spring", R"("anchor": [0, 0, 0], "stiffness": 5)"),
              "/effects/0 needs the key bodies"),
      on_both(effect("spring_between", R"("first": "ball", "second": "bal", "stiffness": 5)"),
              "/effects/0/second is \"bal\"; no body has that name; did you mean ball?"),
      on_both(effect("spring_between", R"("first": "ball", "second": "ball", "stiffness": 5)"),
              "/effects/0 is refused: 'spring between bodies' joins 'ball' to itself"),
      {scene_of(ball + ", " + drop_with(R"("many": {"count": 3, "seed": 1})"),
                effect("spring_between", R"("first": "ball", "second": "drop", "stiffness": 5)")),
       "/effects/0/second is \"drop\"; it stands for 3 bodies; a spring has one at either end"},
      on_both(effect("thruster", R"("bodies": ["drop"], "force": [1, 0, 0])"),
              "/effects/0 is refused: 'thruster' needs an orientation, and 'drop' is a point"),
      on_both(
          effect("thruster", R"("bodies": ["ball"], "force": [1, 0, 0], "from": 2, "until": 1)"),
          "/effects/0/until is 1 s; it must not lie before the start, 2 s"),
      on_both(
          effect("reaction_wheel", R"("bodies": ["drop"], "axis": [1, 0, 0])"),
          "/effects/0 is refused: 'reaction wheel' needs an orientation, and 'drop' is a point"),
      on_both(effect("reaction_wheel", R"("bodies": ["ball"], "axis": [0, 0, 0])"),
              "/effects/0/axis is [0,0,0]; it needs a direction"),
      on_both(
          effect("reaction_wheel",
                 R"("bodies": ["ball"], "axis": [1, 0, 0], "torque": 1, "from": 2, "until": 1)"),
          "/effects/0/until is 1 s; it must not lie before the start, 2 s"),
      on_both(effect("buoyancy", R"("density": 1000, "radius": -1)"),
              "/effects/0/radius is -1 m; it must be 0 or more"),
  };
}

/// Mistakes in float that are correct in double.
inline std::vector<BadScene> scenes_too_wide_for_float() {
  return {
      {scene_of(R"({"name": "x", "mass": 1e300})"),
       "/bodies/0/mass is 1e+300 kg; it does not fit a float, whose largest number is "
       "3.4028234663852886e+38"},
      {scene_of(R"({"name": "x", "mass": 1e-45})"),
       "/bodies/0/mass is 1e-45 kg; it does not fit a float, whose smallest number is "
       "1.1754943508222875e-38"},
      {scene_of(drop_with(R"("position": [1e20, 0, 0])")),
       "/bodies/0/position/0 is 1e+20 m; it must lie between -1e+18 and 1e+18, so that its square "
       "fits a float"},
      {scene_of(R"({"name": "x", "mass": 1, "solid": {"shape": "sphere", "radius": 1e-20}})"),
       "/bodies/0 is refused: its mass, moments of inertia or angular momentum do not fit a "
       "float"},
      {scene_of(ball, effect("point_gravity", R"("strength": 1e39)")),
       "/effects/0/strength is 1e+39 m^3/s^2; it does not fit a float, whose largest number is "
       "3.4028234663852886e+38"},
  };
}

}  // namespace tumble::support
