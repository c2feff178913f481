#include <algorithm>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>

#include "answer.hpp"

namespace tumble::advise {
namespace {

/// As printf would write it.
[[gnu::format(printf, 1, 2)]] std::string formatted(const char* format, ...) {
  std::va_list arguments;
  va_start(arguments, format);
  char buffer[400];
  std::vsnprintf(buffer, sizeof buffer, format, arguments);
  va_end(arguments);
  return buffer;
}

/// A line, and more of them where it is longer than 92 letters, each indented to where the first
/// one's text begins.
std::string line(const char* name, const std::string& text) {
  constexpr std::size_t margin = 19, longest = 92;
  std::string lines = formatted("%-*s", static_cast<int>(margin), name);
  std::size_t column = margin;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find(' ', begin), text.size());
    if (column > margin && column + 1 + (end - begin) > longest) {
      lines += "\n" + std::string(margin, ' ');
      column = margin;
    } else if (column > margin) {
      lines += ' ';
      ++column;
    }
    lines.append(text, begin, end - begin);
    column += end - begin;
    begin = end + 1;
  }
  return lines + "\n";
}

std::string counted(double number, const char* noun) {
  return formatted("%.0f %s%s", number, noun, number == 1 ? "" : "s");
}

std::string method_of(const Found& found, const Frames& frames) {
  const std::string& scheme = found.candidate->scheme;
  std::string text = found.candidate->method + (scheme.empty() ? "" : ", scheme " + scheme) +
                     ", in " + found.candidate->precision;
  if (!found.candidate->takes_steps) return text + ", asked once a state";
  if (found.candidate->chooses_steps())
    return text + (found.candidate->is_given_angle ? ", angle " : ", tolerance ") +
           formatted("%.3g rad a %s: ", found.candidate->given(found.fineness),
                     found.candidate->is_given_angle ? "step" : "second") +
           counted(static_cast<double>(found.errors.steps), "step") + " in all" +
           (found.errors.rejected > 0 ? formatted(" and %ld repeated", found.errors.rejected)
                                      : "") +
           formatted(", %.3g a state",
                     static_cast<double>(found.errors.steps) / static_cast<double>(frames.count));
  const auto steps = static_cast<double>(found.fineness);
  const double rate = static_cast<double>(frames.rate) * steps;
  return text + ", " + counted(steps, "step") +
         " a state: " + formatted("%.6g s, %.0f a second", 1 / rate, rate);
}

/// A number in plain digits, two of which count.
std::string two_digits(double value) {
  if (value < 99.5) return formatted("%.2g", value);
  const double unit = std::pow(10, std::floor(std::log10(value)) - 1);
  return formatted("%.0f", std::round(value / unit) * unit);
}

std::string cost_of(double ratio, const char* format) {
  const std::string times = formatted(format, ratio);
  return std::strtod(times.c_str(), nullptr) == 1 ? "the same cost: " : times + " times the cost: ";
}

std::string counted_bodies(double number) {
  return formatted("%.0f %s", number, number == 1 ? "body" : "bodies");
}

/// The errors that somebody asked about.
std::string errors_of(const Errors& errors, const Tolerance& tolerance) {
  std::string text;
  if (std::isfinite(tolerance.angle)) text = formatted("%.2g rad", errors.angle);
  if (std::isfinite(tolerance.place))
    text += (text.empty() ? "" : " and ") + formatted("%.2g m", errors.place);
  return text;
}

std::string ten_times_better(const Answer& answer) {
  if (!answer.better) return "can't be confirmed";
  const Found &better = *answer.better, &winner = *answer.verdict.winner;
  if (better.candidate == winner.candidate && better.fineness == winner.fineness)
    return "the cheapest is that already";
  return cost_of(better.nanoseconds / winner.nanoseconds, "%.2g") +
         method_of(better, answer.asked.frames) + ", " +
         errors_of(better.errors, answer.asked.tolerance);
}

std::string wanted(const Tolerance& tolerance) {
  return errors_of({.angle = tolerance.angle, .place = tolerance.place}, tolerance);
}

std::string question(const Answer& answer) {
  const Options& asked = answer.asked;
  std::string text;
  if (asked.top) {
    const auto& I = asked.top->moments;
    const auto& w = asked.top->spin;
    text = formatted("A free top: moments %g, %g, %g kg m^2, spin %g, %g, %g rad/s", I[0], I[1],
                     I[2], w[0], w[1], w[2]);
  } else {
    text = "The scene " + asked.scene.filename().string() + ": " +
           counted_bodies(static_cast<double>(answer.bodies));
  }
  return text +
         formatted(", for %g s, %ld state%s a second\n", asked.frames.seconds(), asked.frames.rate,
                   asked.frames.rate == 1 ? "" : "s") +
         line("wanted", "errors of at most " + wanted(asked.tolerance) + ", all the way") +
         (asked.top
              ? ""
              : line("tried",
                     "every method that a scene can name, and each scheme that may pay, whatever "
                     "the file names"));
}

std::string frame_of(const Answer& answer, const Found& found) {
  const double fit = std::floor(1e9 / found.nanoseconds);
  const double bodies = fit * static_cast<double>(answer.bodies);
  if (fit < 1) return "not even one of these fits in a frame of 1/60 s";
  if (answer.asked.top)
    return counted(bodies, "such top") + " in each frame of 1/60 s, on one thread, one by one";
  return counted(fit, "such scene") +
         " in each frame of 1/60 s, on one thread: " + counted_bodies(bodies);
}

}  // namespace

std::string text_of(const Answer& answer) {
  const Options& asked = answer.asked;
  std::string text = question(answer);
  if (!answer.verdict.winner) {
    text += line("refused", answer.refusal);
    text += line("reference",
                 answer.reference + ", sure to " + errors_of(answer.uncertainty, asked.tolerance));
    if (answer.verdict.nearest)
      text += line("nearest", method_of(*answer.verdict.nearest, asked.frames) + ": " +
                                  errors_of(answer.verdict.nearest->errors, asked.tolerance));
    return text;
  }
  const Found& winner = *answer.verdict.winner;
  text += line("cheapest", method_of(winner, asked.frames));
  const double ratio = winner.errors.of(asked.tolerance);
  const std::string less = ratio > 0 ? two_digits(1 / ratio) : "";
  text += line("expected error", errors_of(winner.errors, asked.tolerance) +
                                     (less.empty()  ? ""
                                      : less == "1" ? ", just within it"
                                                    : ", " + less + " times less than wanted"));
  if (asked.top)
    text += line("", formatted("relative errors: energy %.2g, angular momentum %.2g",
                               winner.errors.energy, winner.errors.momentum));
  text += line("confirmed", "against " + answer.reference + ", sure to " +
                                errors_of(answer.uncertainty, asked.tolerance));
  if (asked.top) text += line("", "with this top, and with three that are like it");
  text += line("costs", formatted("%.0f ns for each simulated second", winner.nanoseconds));
  text += line("that makes", frame_of(answer, winner));
  text += line("ten times better", ten_times_better(answer));
  if (answer.worse)
    text += line("ten times cheaper", errors_of(answer.worse->errors, asked.tolerance) + ": " +
                                          method_of(*answer.worse, asked.frames));
  else if (answer.least)
    text += line("ten times cheaper", formatted("nothing is; at %.2g of the cost: ",
                                                answer.least->nanoseconds / winner.nanoseconds) +
                                          method_of(*answer.least, asked.frames) + ", " +
                                          errors_of(answer.least->errors, asked.tolerance));
  for (std::size_t n = 0; n < std::min<std::size_t>(answer.verdict.others.size(), 3); ++n) {
    const Found& other = answer.verdict.others[n];
    text +=
        line(n == 0 ? "would do too" : "", cost_of(other.nanoseconds / winner.nanoseconds, "%.2f") +
                                               method_of(other, asked.frames));
  }
  return text;
}

}  // namespace tumble::advise
