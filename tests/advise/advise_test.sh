#!/usr/bin/env bash
# advise_test.sh ADVISE PROMISE_KEPT SCRATCH SCHEMA PYTHON: what the program advise answers to good questions and bad ones, and
# whether its promises hold when they are tried against exact solutions. Nothing here depends on how fast the machine is.
set -u
program=$1
promise_kept=$2
scratch=$3
schema=$4
python=$5
# shellcheck source=tests/verify.sh
. "$(dirname -- "${BASH_SOURCE[0]}")/../verify.sh"

rm -rf "$scratch"
mkdir -p "$scratch"
cd "$scratch" || exit 1

says() { [[ $(tr -s ' \n' ' ' <<<"$output") == *"$1"* ]]; } # wherever its lines are broken
is_silent() { [ -z "$output$errors" ]; }

# Promises: each is tried against an exact solution by a program that shares nothing with advise.
keeps() { # NAME ARGUMENT...: with time enough for a machine that does much else
  local name=$1
  shift
  run "$@" --json --longest-run 60
  printf '%s\n' "$output" >"$name.json"
  verify "$name: it promises something" ends_with 0
  verify "$name: the promise holds" "$promise_kept" "$name.json"
}
keeps ordinary_coarse --inertia 1,2,3 --spin 1,2,0.5 --for 10 --angle 0.1
keeps ordinary_float --inertia 1,2,3 --spin 1,2,0.5 --for 2 --angle 1e-4 --precision float
keeps ordinary_fine --inertia 1,2,3 --spin 1,2,0.5 --for 10 --angle 1e-11
keeps seldom --inertia 1,2,3 --spin 1,2,0.5 --for 10 --angle 1e-6 --rate 1
keeps other_order --inertia 3,1,2 --spin=-0.5,1,2 --for 10 --angle 1e-8
keeps rod --inertia 1.7231e-4,6.58e-6,1.7243e-4 --spin 2,60,1 --for 1 --angle 1e-6
keeps needle --inertia 1,1e-6,1.0000005 --spin 1,200,0.5 --for 1 --angle 1e-6
keeps ball --inertia 2,2,2 --spin 1,2,3 --for 5 --angle 1e-9
keeps hardly_a_wobble --inertia 1,1e-12,1 --spin 1e-200,1e-200,1 --for 1 --angle 1e-3
keeps beside_the_middle_axis --inertia 1,2,3 --spin 1e-200,1,1e-300 --for 1 --angle 1e-6
keeps two_like_axes --inertia 3,3,2 --spin 1,1e-7,1e-250 --for 1 --angle 1e-6
keeps own_steps --inertia 1,2,3 --spin 1,2,0.5 --for 20 --angle 1e-6 --rate 1 --steps own
keeps own_steps_in_float --inertia 1,2,3 --spin 1,2,0.5 --for 4 --angle 1e-4 --rate 1 --steps own --precision float
keeps own_steps_of_a_rod --inertia 1.7231e-4,6.58e-6,1.7243e-4 --spin 2,60,1 --for 1 --angle 1e-8 --rate 4 --steps own
keeps own_steps_a_frame --inertia 1,2,3 --spin 1,2,0.5 --for 2 --angle 1e-9 --steps own
keeps own_steps_that_are_repeated --inertia 1,10,10.5 --spin 0.01,0.02,4 --for 20 --angle 1e-6 --rate 1 --steps own
keeps even_steps_in_double --inertia 1,2,3 --spin 1,2,0.5 --for 2 --angle 1e-4 --rate 1 --steps even --precision double
keeps many_steps_a_state --inertia 1,2,3 --spin 10,20,5 --for 2 --rate 1 --angle 1e-8 --steps even # one costs far less than a tenth
keeps many_states --inertia 2,2,2 --spin 1,2,3 --for 140 --angle 0.1 --steps even # every third one is compared
keeps hardly_a_turn --inertia 1,2,3 --spin 1e-20,2e-20,0.5e-20 --for 1 --angle 8e-17 --rate 1 # the reference is not sure of a tenth
keeps scene t_handle --for 3 --angle 1e-3
keeps scene_in_float t_handle --for 1 --angle 1e-3 --precision float
keeps flight_in_double t_handle --for 3 --angle 1e-5 --precision double
keeps orbits orbit --for 101 --place 100 --rate 1 # of a scene a hundred states at most are held against the truth, with the last
keeps orbits_of_two_prices orbit --for 100 --place 0.1 --rate 1 # a tenth of which is dearer
keeps fine_orbits orbit --for 100 --place 0.001 --rate 1

# The answer in words.
run --inertia 1,2,3 --spin 1,2,0.5 --for 5 --angle 1e-6
for words in "errors of at most 1e-06 rad" "cheapest " "expected error " "times less than wanted" \
  "against the exact solution" "ns for each simulated second" "in each frame of 1/60 s" "ten times better" "ten times cheaper"; do
  verify "the answer says \"$words\"" says "$words"
done
run --inertia 1,2,3 --spin 1,2,0.5 --for 10 --angle 1e-6 --rate 1 --steps own
for words in "own steps, in " "tolerance " " rad a second: " " steps in all" " a state"; do
  verify "of a method that chooses its steps the answer says \"$words\"" says "$words"
done
verify "and nothing of a rung with steps of one length" says_not " a state: "
run --inertia 1,2,3 --spin 1e4,9e3,5e3 --for 100 --angle 1e-3 --rate 1 --steps own --longest-run 0.001
verify "what can't be carried in the time that a run may take is refused" ends_with 1
run --inertia 2,2,2 --spin 1,2,3 --for 5 --angle 1e-9 --steps own
verify "a ball has no need of steps that are chosen" says "no method with such steps is needed"
run tethered_box --for 1 --angle 0.1 --rate 1 --longest-run 60
verify "no step that is tried, too long for a rope though it may be, warns of itself" [ -z "$errors" ]
run magnus_ball --for 1 --place 0.1 --longest-run 60
verify "a scene is answered" answers 0 "Richardson's extrapolation of runs with"
verify "with its bodies" says "The scene magnus_ball.json: 2 bodies, for 1 s, 60 states a second"
run --inertia 1,2,3 --spin 1,2,0.5 --for 0.29 --rate 100 --angle 0.1
verify "0.29 * 100 is a little less than 29, and that is taken for 29" says "for 0.29 s, 100 states a second"
run --help
verify "--help tells the options" answers 0 "--inertia A,B,C"
"$program" --help >/dev/full 2>errors.txt
code=$? output="" errors=$(cat errors.txt)
rm errors.txt
verify "help that can't be written is told" fails 1 "the answer can't be written"
run --inertia 2,2,2 --spin 1,2,3 --for 5 --angle 1e-9 --json=false
verify "--json=false is no JSON" [ "${output:0:1}" != "{" ]

# What can't be confirmed is not promised.
for tolerance in 1e-17 1e-16; do
  run --inertia 1,2,3 --spin 1,2,0.5 --for 10 --angle $tolerance
  verify "$tolerance rad is refused" answers 1 "refused"
done
run --inertia 1,2,3 --spin 1,2,0.5 --for 10 --angle 1e-9 --precision float
verify "what float can't store is refused with the reason" says "the exact orientations, rounded to float, are off by up to"
verify "and the remedy" says "or let double be tried"
verify "before any method is tried" says_not "nearest "
verify "and ends with 1" ends_with 1
run --inertia 2,2,2 --spin 0,0,6.283185307179586 --for 1 --angle 1e-9 --precision float
verify "even if float can store the last state" says "rounded to float, are off by up to"
run --inertia 1,2,3 --spin 1,2,0.5 --for 1 --angle 1e-16
verify "and so is what double can't store" says "the exact orientations, rounded to double, are off by up to"
run --inertia 1,2,3 --spin 0,0,0 --for 1 --angle 1e-16
verify "where double stores everything exactly, the finest tolerance is met" says "expected error 0 rad"
verify "and no quotient by zero is told" says_not "inf"
run --inertia 1,2,3 --spin 1,2,0.5 --for 10 --angle 3e-7 --precision float --rate 10 --longest-run 0.01
verify "what float can store and no method keeps is refused" says "no method here could be confirmed to be that accurate"
verify "with what came nearest" answers 1 "nearest "
run --inertia 1,2,3 --spin 1e-20,2e-20,0.5e-20 --for 1 --angle 8e-18 --rate 1
verify "a reference that is off by a third of what is wanted confirms nothing" says "the reference is not sure enough"
if [ -n "$python" ]; then
  on_terminal() { # ARGUMENT...
    errors="" output=$("$python" -c '
import os, pty, subprocess, sys
ours, its = pty.openpty()
with subprocess.Popen(sys.argv[1:], stderr=its, stdout=subprocess.PIPE) as advise:
    os.close(its)
    said = b""
    try:
        while part := os.read(ours, 4096):
            said += part
    except OSError:
        pass  # so a terminal ends
    print(advise.stdout.read().decode().count("trying"), said.decode())' "$program" "$@")
    code=$?
  }
  on_terminal --inertia 1,2,3 --spin 1,2,0.5 --for 1 --angle 1e-4 --precision float --rate 1
  verify "on a terminal it says what it tries" says "what was asked for: trying exact solution in float, "
  verify "and for what" says "a tenth of the error: trying exact solution in float, "
  verify "and takes that away again" [ "${output: -4}" = $'\r\e[K' ]
  verify "and the answer is free of it" [ "${output%% *}" = 0 ]
  verify "and no other precision than the one that is asked for is tried" says_not " in double, "
  on_terminal --inertia 1,2,3 --spin 1,2,0.5 --for 1 --angle 1e-4 --precision double --rate 1
  verify "which may be double" says "what was asked for: trying exact solution in double, "
  verify "alone" says_not " in float, "
  on_terminal --inertia 1,2,3 --spin 1,2,0.5 --for 1 --angle 1e-4 --rate 1
  for precision in double float; do
    verify "of a free top whose precision nobody names it tries methods in $precision" says "what was asked for: trying exact solution in $precision, "
  done
  on_terminal orbit --for 10 --place 1e6 --rate 1
  verify "a scene needs a reference first" says "computing the reference"
  verify "where nothing tumbles it tries one method by three schemes in two precisions" says ": trying splitting in double, 1 of 6"
  printf '{"duration": 1, "bodies": [{"name": "a", "mass": 1}], "effects": [{"kind": "gravity", "acceleration": [0, 0, -9]},
    {"kind": "linear_damping", "rate": 0.1}]}' >damped.txt
  on_terminal damped.txt --for 1 --place 1e6 --rate 1
  verify "where damping acts no scheme promises more than Euler's, and Verlet's alone is tried beside it" says ": trying splitting in double, 1 of 4"
  on_terminal t_handle --for 1 --angle 1
  verify "and where nothing is kicked all methods by one scheme" says ": trying exact_solution in double, 1 of 30"
fi
run --inertia 1,2,3 --spin 1,2,0.5 --for 10 --angle 1e-17 --json
printf '%s\n' "$output" >refused.json
verify "JSON says it too" says '"confirmed": false'
run t_handle --for 1 --angle 1e-15 --json
printf '%s\n' "$output" >refused_scene.json
verify "a scene's reference that is not sure enough confirms nothing" answers 1 "the reference is not sure enough"
# A rounding decides when this one flips, and the exact solution itself has the flips early or late.
run --inertia 1,2,3 --spin 0.3,1,0.17320508075688772 --for 200 --angle 1e-6
verify "beside the separatrix the exact solution confirms nothing" says "the reference is not sure enough"
run --inertia 1e-200,1e-200,1e-200 --spin 1,2,3 --for 1 --angle 0.1 --precision float
verify "moments that float can't hold are refused in float" says "can't hold these numbers"

# Every answer in JSON is as the schema says.
cat >validate.py <<'END_OF_SCRIPT'
import json, pathlib, sys
from jsonschema import Draft202012Validator
schema = json.loads(pathlib.Path(sys.argv[1]).read_text())
Draft202012Validator.check_schema(schema)
validator = Draft202012Validator(schema)
answers = sorted(pathlib.Path(".").glob("*.json"))
wrong = [f"{path}: {error.message}" for path in answers for error in validator.iter_errors(json.loads(path.read_text()))]
print("\n".join(wrong) or f"{len(answers)} answers are valid")
broken = json.loads(answers[0].read_text())
broken["confirmed"] = False
sys.exit(bool(wrong) or len(answers) < 10 or validator.is_valid(broken))
END_OF_SCRIPT
if [ -n "$python" ] && "$python" -c "import jsonschema" 2>/dev/null; then
  output="" errors="" code=0
  verify "the answers in JSON are as the schema says" "$python" validate.py "$schema"
else
  echo "not tried, for Python's jsonschema is missing: whether the answers in JSON are as the schema says"
fi

# The numbers of every answer agree with each other.
cat >agree.py <<'END_OF_SCRIPT'
import json, math, pathlib
near = lambda a, b: math.isclose(a, b, rel_tol=1e-12)
for path in sorted(pathlib.Path(".").glob("*.json")):
    answer = json.loads(path.read_text())
    wanted, winner = answer["question"]["wanted_error"], answer["cheapest"]
    part = lambda found: max(found["expected_error"][key] / wanted[key] for key in wanted if wanted[key] is not None)
    for found in [winner, answer["ten_times_better"], answer["ten_times_cheaper"], *answer["others"]]:
        if found is None:
            continue
        even, own = found["steps_per_second"] is not None, found["rejected_steps"] is not None
        exactly = "moments" in answer["question"] and found["method"] == "exact solution"
        assert even + own + exactly == 1, path
        assert own or "own_steps" not in path.stem, path  # a question is called by what it asks for
        assert even or "even_steps" not in path.stem, path
        assert found["precision"] in path.stem or not path.stem.endswith(("_in_float", "_in_double")), path
        assert own == (found["tolerance_per_second"] is not None) + (found["angle_per_step"] is not None), path
        assert own or found["steps"] == (round(found["steps_per_second"] * answer["question"]["seconds"]) if even else None), path
        assert found["time_step"] is None or near(found["time_step"] * found["steps_per_second"], 1), path
        assert part(found) == 0 or near(found["margin"] * part(found), 1), path
        bodies = math.floor(1e9 / found["nanoseconds_per_simulated_second"]) * answer["question"].get("bodies", 1)
        assert found["bodies_per_sixtieth"] == bodies, path
        for key, error in found["expected_error"].items():  # what the reference may be off by is counted in
            assert error is None or "scene" not in answer["question"] or error >= answer["reference_uncertainty"][key], path
    if "moments" in answer["question"]:  # 290 roundings and 65 a radian, and it turns hardly slower than at the start
        radians = math.hypot(*answer["question"]["spin"]) * answer["question"]["seconds"]
        least = 5 * (math.sqrt(290 / 3) + math.sqrt(65 / 3) * radians) * 2 ** -64
        assert answer["reference_uncertainty"]["angle"] >= (1 - 1e-12) * min(least, math.pi), path
    if winner:
        assert part(winner) <= 1, path
        names = lambda found: [found["method"], found["scheme"], found["precision"]]
        for other in answer["others"]:
            assert names(other) != names(winner), path
            assert 1 <= other["nanoseconds_per_simulated_second"] / winner["nanoseconds_per_simulated_second"] < 4, path
    if answer["ten_times_better"]:
        assert part(answer["ten_times_better"]) <= 0.1, path
        for key, error in answer["reference_uncertainty"].items():  # a quarter of that tenth
            assert error is None or error <= wanted[key] / 40, path
    assert answer["ten_times_cheaper"] or path.stem != "many_steps_a_state", path
    if answer["ten_times_cheaper"]:
        assert answer["least_cost"] is None, path
        cheap = answer["ten_times_cheaper"]["nanoseconds_per_simulated_second"]
        assert cheap <= winner["nanoseconds_per_simulated_second"] / 10, path
END_OF_SCRIPT
if [ -n "$python" ]; then
  output="" errors=$("$python" agree.py 2>&1) code=$?
  verify "the numbers of each answer agree with each other" ends_with 0
fi

# Mistakes.
refuses() { # COMPLAINT ARGUMENT...
  local complaint=$1
  shift
  run "$@"
  verify "refused: $complaint" fails 2 "$complaint"
}
top="--inertia 1,2,3 --spin 1,2,0.5 --for 10"
# shellcheck disable=SC2086  # lists of words
{
  refuses "which scene, or which --inertia and --spin?"
  refuses "no scene and no file is called t_handel; did you mean t_handle?" t_handel --for 1 --angle 1
  refuses "for how long?" t_handle --angle 1
  refuses "how accurate? --angle RAD or --place METRES say it" t_handle --for 1
  refuses "how accurate? --angle RAD says it" $top
  refuses "--inertia needs --spin" --inertia 1,2,3 --for 1 --angle 1
  refuses "--spin needs --inertia" --spin 1,2,3 --for 1 --angle 1
  refuses "either a scene or --inertia and --spin, not both" t_handle $top --angle 1
  refuses "--place is for scenes" $top --angle 1 --place 1
  refuses "--angle is 0 rad; it must be greater than 0 and at most 3 rad" $top --angle 0
  refuses "--angle is -1 rad; it must be greater than 0 and at most 3 rad" $top --angle=-1
  refuses "--angle is nan; it must be a number of rad" $top --angle nan
  refuses "--angle is 1e-6rad; it must be a number of rad" $top --angle 1e-6rad
  refuses "--place is inf; it must be a number of m" t_handle --for 1 --place inf
  refuses "--for is 0 s; it must be greater than 0 and at most 1e+06 s" t_handle --for 0 --angle 1
  refuses "--for is 0.01 s; with 60 states a second it must be a whole number of states, not 0.6" t_handle --for 0.01 --angle 1
  refuses "and at most 10000000 are compared: lower --rate" t_handle --for 1e6 --angle 1
  refuses "--rate is 0 states a second; it must be at least 1 and at most 1e+06 states a second" t_handle --for 1 --angle 1 --rate 0
  refuses "--rate is 1.5; it must be a whole number of states a second" t_handle --for 2 --angle 1 --rate 1.5
  refuses "--precision is half; it must be float, double or any" $top --angle 1 --precision half
  refuses "--steps is odd; it must be even, own or any" $top --angle 1 --steps odd
  refuses "--steps own is for a free top: the steps of a scene have one length" t_handle --for 1 --angle 1 --steps own
  refuses "--longest-run is 0 s; it must be at least 0.001 and at most 600 s" $top --angle 1 --longest-run 0
  refuses "--inertia is 1,2; it must be three numbers of kg m^2 with commas between them, such as 1,2,3" --inertia 1,2 --spin 1,2,3 --for 1 --angle 1
  refuses "--inertia is 1,2,3,4; it must be three numbers" --inertia 1,2,3,4 --spin 1,2,3 --for 1 --angle 1
  refuses "--inertia is 1,2,nan; it must be three numbers" --inertia 1,2,nan --spin 1,2,3 --for 1 --angle 1
  refuses "--inertia is 1,-2,3 kg m^2; each moment must be greater than 0" --inertia 1,-2,3 --spin 1,2,3 --for 1 --angle 1
  refuses "--inertia is 0,1,1 kg m^2; each moment must be greater than 0" --inertia 0,1,1 --spin 1,2,3 --for 1 --angle 1
  refuses "--inertia is 1,2,9 kg m^2; no body has these: the largest must not be more than the sum of the other two" --inertia 1,2,9 --spin 1,2,3 --for 1 --angle 1
  refuses "--inertia is 1,2,; it must be three numbers" --inertia 1,2, --spin 1,2,3 --for 1 --angle 1
  refuses "--inertia is 1e-301,1e-301,1e-301 kg m^2; each must lie between 1e-300 and 1e300" --inertia 1e-301,1e-301,1e-301 --spin 1,2,3 --for 1 --angle 1
  refuses "--inertia is 1,2e300,2e300 kg m^2; each must lie between 1e-300 and 1e300" --inertia 1,2e300,2e300 --spin 1,2,3 --for 1 --angle 1
  refuses "--inertia is 1,2,3.00001 kg m^2; no body has these" --inertia 1,2,3.00001 --spin 1,2,3 --for 1 --angle 1
  refuses "--spin is -1e7,2,3 rad/s; each must lie between -1e6 and 1e6" --inertia 1,2,3 --spin=-1e7,2,3 --for 1 --angle 1
  refuses "--angle is 4 rad; it must be greater than 0 and at most 3 rad" $top --angle 4
  refuses "--place is 1e13 m; it must be greater than 0 and at most 1e+12 m" t_handle --for 1 --place 1e13
  refuses "--spin is 1,2,1e7 rad/s; each must lie between -1e6 and 1e6" --inertia 1,2,3 --spin 1,2,1e7 --for 1 --angle 1
  refuses "there is no option --angel; did you mean --angle?" $top --angel 1
  refuses "one word too many: coin" t_handle coin --for 1 --angle 1
}
run --inertia 1,2,3.000002 --spin 1,1e6,-1e6 --for 1e-6 --rate 1e6 --angle 3 --longest-run 600 # all as large as they may be
verify "what is at its bound is none" ends_with 0
printf '{"duration": 1, "bodies": [{"name": "a", "mass": 1, "position": [1e40, 0, 0]}]}' >far.txt
refuses "far.txt: /bodies/0/position/0 is 1e+40 m; it does not fit a float" far.txt --for 1 --place 1 --precision float
run far.txt --for 1 --place 1 --longest-run 60
verify "what float can't hold is answered in double" says ", in double"
verify "by the first runs of which three extrapolations agree" says "runs with 3 and 5 steps a state, sure to 0 m"
printf '{"duration": 1, "bodies": [{"name": "a", "mass": 1}], "effects": [{"kind": "point_gravity", "strength": 1}]}' >centre.txt
run centre.txt --for 1 --place 1
verify "a scene that can't be run is told" fails 1 "the scene can't be run: 'a' at 0 s (step 0): point gravity gives a force of"
printf '{"title": ' >bad_scene.txt
refuses "bad_scene.txt: line 1, column 11: not valid JSON" bad_scene.txt --for 1 --angle 1

[ "$failures" -eq 0 ]
