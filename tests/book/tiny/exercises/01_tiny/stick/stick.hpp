#pragma once

double stick_length(double height) {
  todo("a longer stick");
}
