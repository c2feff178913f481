// A float that is damped for ever does not become zero by itself.
#include <support/record.hpp>
#include <tumble/damping.hpp>

using namespace tumble;

int main(int argument_count, char** arguments) {
  support::Notebook notebook(argument_count, arguments);
  const float kept = fraction_kept(1.0f, 1.0f / 60);
  float crawling = 1;
  Particlef stopping = make_particle(1.0f, Vec3f(0, 0, 0), Vec3f(1, 0, 0));
  std::printf("   time   multiplied only       damp()\n");
  int stopped = 0;
  for (int n = 0; n <= 60 * 120; ++n) {
    if (n % (60 * 20) == 0)
      std::printf("%5d s   %-15.3g   %g m/s\n", n / 60, double(crawling),
                  double(stopping.velocity.x()));
    if (stopping.velocity.x() == 0 && stopped == 0) stopped = n;
    crawling *= kept;
    damp(stopping, kept);
  }
  support::expect(crawling > 0 && crawling * kept == crawling,
                  "the product rounds back up for ever");
  support::expect(!std::isnormal(crawling), "and what it is stuck at is a denormal number");
  support::expect(stopping.velocity.x() == 0, "damp() stops it");
  notebook.value("stopped", support::number("%.1f s", stopped / 60.0));
  notebook.value("kept", support::number("%.4f", double(kept)));
  notebook.value("stuck", support::number("%.1e", double(crawling)));
  notebook.value("slowest_float", support::number("%.1e", double(slowest_speed<float>)));
}
