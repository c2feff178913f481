// The debugger held the game for five seconds. What does the clock make of it? And of nonsense?
#include <functional>
#include <support/record.hpp>
#include <tumble/step_clock.hpp>

using namespace tumble;

int main(int argument_count, char** arguments) {
  support::Notebook notebook(argument_count, arguments);
  const std::int64_t millisecond = 1'000'000;
  //! [breakpoint]
  StepClock clock = make_step_clock(steps_per_second(60));
  for (const std::int64_t frame : {17, 16, 5000, 17, 17}) {
    const std::int64_t due = steps_due(clock, frame * millisecond);
    std::printf("a frame of %4d ms: steps due %d\n", int(frame), int(due));
  }
  //! [breakpoint]
  std::printf("\ntime in           %12lld ns\n", static_cast<long long>(clock.time_in));
  std::printf("dropped by time   %12lld ns\n", static_cast<long long>(clock.dropped_time));
  std::printf("steps handed out  %12lld of 50000000/3 ns\n", static_cast<long long>(clock.steps));
  std::printf("steps dropped     %12lld\n", static_cast<long long>(clock.dropped_steps));
  std::printf("left for later    %12lld/3 ns\n", static_cast<long long>(clock.remainder));
  const std::int64_t left = (clock.time_in - clock.dropped_time) * 3,
                     right = (clock.steps + clock.dropped_steps) * 50'000'000 + clock.remainder;
  std::printf("\n(time in - dropped) * 3 = %lld = (steps + dropped) * 50000000 + left\n",
              static_cast<long long>(left));
  support::expect(left == right, "the books balance exactly");

  std::printf("\n");
  int refused = 0;
  const auto attempt = [&refused](const std::function<void()>& action) {
    try {
      action();
    } catch (const std::invalid_argument& error) {
      std::printf("%s\n", error.what());
      ++refused;
    }
  };
  attempt([&] { steps_due(clock, -1); });
  attempt([&] { steps_due(clock, nanoseconds_of(std::nan(""))); });
  attempt([&] { steps_due(clock, nanoseconds_of(1e30)); });
  attempt([] { steps_per_second(0); });
  support::expect(refused == 4, "every one of the four is refused");
}
