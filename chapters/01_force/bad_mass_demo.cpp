// What a mass that cannot be gets: a sentence, before anything moves.
#include <support/refusals.hpp>
#include <tumble/particle.hpp>

using namespace tumble;

int main(int argument_count, char** arguments) {
  support::Notebook notebook(argument_count, arguments);
  support::Table table = support::table_of_refusals(notebook, "bad_masses");
  int refused = 0;
  const auto attempt = [&](const char* what, float mass) {
    refused += support::try_it(table, what, "make_particle", [mass] { make_particle(mass); });
  };
  using Limits = std::numeric_limits<float>;
  attempt("no mass", 0);
  attempt("a mass below zero", -2);
  attempt("a mass of 0/0", Limits::quiet_NaN());
  attempt("an infinite mass", Limits::infinity());
  attempt("a mass at the end of float's range", 1e-41f);
  support::expect(refused == 5, "every one of the five masses is refused");
  // Below the normal numbers a digit is lost with every halving; the smallest of all has one left.
  notebook.value("digits_left",
                 std::to_string(std::ilogb(1e-41f) - std::ilogb(Limits::denorm_min()) + 1));
  notebook.value("digits", std::to_string(Limits::digits));
}
