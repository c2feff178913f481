#include "page_text.hpp"

#include <support/checks.hpp>

using namespace tumble::simulate;

TEST_CASE("The engine's bytes stand in a page as RFC 4648 writes them") {
  for (const auto& [bytes, text] : {std::pair("", ""),
                                    {"f", "Zg=="},
                                    {"fo", "Zm8="},
                                    {"foo", "Zm9v"},
                                    {"foob", "Zm9vYg=="},
                                    {"fooba", "Zm9vYmE="},
                                    {"foobar", "Zm9vYmFy"},
                                    {"\xff\xef\xbe", "/+++"}})
    CHECK(base64(bytes) == text);
}

TEST_CASE("What a title says stands in a page as it is") {
  CHECK(escaped("a < b & c > d, &lt;") == "a &lt; b &amp; c &gt; d, &amp;lt;");
}
