/// @file
/// A value of a scene file with its place in the file, so that whatever is wrong with it can be
/// said well.
#pragma once

#include <optional>
#include <tumble/explained.hpp>
#include <tumble/require.hpp>
#include <tumble/scene/keys.hpp>
#include <tumble/scene/number_range.hpp>
#include <tumble/scene/parse_json.hpp>

namespace tumble {

/// What is read, and for which kind of number.
struct Reading {
  std::string file;
  NumberRange range;
};

/// "a body", "an effect".
inline std::string with_article(std::string_view noun) {
  return (std::string_view("aeiou").find(noun[0]) == std::string_view::npos ? "a " : "an ") +
         std::string(noun);
}

/// A value and where it stands.
class Value {
 public:
  Value(const Reading& reading, std::string pointer, const nlohmann::json& json,
        std::string_view unit = {})
      : reading_(&reading), pointer_(std::move(pointer)), json_(&json), unit_(unit) {}

  const std::string& pointer() const { return pointer_; }
  const Reading& reading() const { return *reading_; }
  const nlohmann::json& json() const { return *json_; }

  /// Throws "FILE: POINTER SENTENCE".
  [[noreturn]] void fail(const std::string& sentence) const {
    throw SceneError(reading_->file, pointer_, sentence);
  }
  /// Throws "FILE: POINTER is VALUE UNIT; RULE".
  [[noreturn]] void reject(const std::string& rule) const {
    std::string value = json_->dump();
    if (value.size() > 60) value = value.substr(0, 57) + "...";
    fail("is " + value + (unit_.empty() || !json_->is_number() ? "" : " ") +
         (json_->is_number() ? std::string(unit_) : "") + "; " + rule);
  }
  /// Calls a function of the library and adds file and place to what it throws.
  template <class Action>
  auto guarded(const Action& action) const {
    return explained(action, [this](const std::invalid_argument& refusal) {
      fail(std::string("is refused: ") + refusal.what());
    });
  }

  Value at(std::size_t index) const {
    return {*reading_, pointer_to(pointer_, std::to_string(index)), (*json_)[index], unit_};
  }
  std::size_t size() const { return json_->size(); }
  bool is_array() const { return json_->is_array(); }
  bool is_object() const { return json_->is_object(); }

  double number() const {
    if (!json_->is_number()) reject("it must be a number" + in_unit());
    const double number = json_->get<double>();
    const NumberRange& range = reading_->range;
    const std::string name(range.precision);
    if (std::abs(number) > range.largest)
      reject("it does not fit a " + name + ", whose largest number is " + text_of(range.largest));
    if (number != 0 && std::abs(number) < range.smallest)
      reject("it does not fit a " + name + ", whose smallest number is " + text_of(range.smallest));
    return number;
  }
  double positive() const {
    const double value = number();
    if (!(value > 0)) reject("it must be greater than 0");
    return value;
  }
  double not_negative() const {
    const double value = number();
    if (value < 0) reject("it must be 0 or more");
    return value;
  }
  std::int64_t whole(std::int64_t least, std::int64_t most) const {
    const std::string rule =
        "it must be a whole number from " + std::to_string(least) + " to " + std::to_string(most);
    if (!json_->is_number_integer()) reject(rule);
    if (json_->is_number_unsigned() &&
        json_->get<std::uint64_t>() > static_cast<std::uint64_t>(most))
      reject(rule);
    const auto value = json_->get<std::int64_t>();
    if (value < least || value > most) reject(rule);
    return value;
  }
  bool boolean() const {
    if (!json_->is_boolean()) reject("it must be true or false");
    return json_->get<bool>();
  }
  std::string text() const {
    if (!json_->is_string()) reject("it must be a text");
    std::string text = json_->get<std::string>();
    if (plain(text) != text) reject("a text holds no control characters but line ends and tabs");
    return text;
  }
  /// A list with at least one element.
  const Value& list(const std::string& of) const {
    if (!is_array()) reject("it must be a list of " + of);
    if (json_->empty()) reject("it must have at least one element: a list of " + of);
    return *this;
  }
  Vec3d vector() const {
    if (!is_array() || size() != 3) reject("it must be a list of three numbers" + in_unit());
    const double most = reading_->range.largest_component;
    Vec3d vector;
    for (std::size_t i = 0; i < 3; ++i) {
      const Value component = at(i);
      vector[static_cast<Eigen::Index>(i)] = component.number();
      if (std::abs(component.number()) > most)
        component.reject("it must lie between " + text_of(-most) + " and " + text_of(most) +
                         ", so that its square fits a " + std::string(reading_->range.precision));
    }
    return vector;
  }
  /// The number of this text among `words`.
  template <class Words>
  std::size_t one_of(const std::string& what, const Words& words) const {
    const std::string word = text();
    const auto found = std::find(words.begin(), words.end(), word);
    if (found != words.end()) return static_cast<std::size_t>(found - words.begin());
    const std::vector<std::string_view> candidates(words.begin(), words.end());
    const std::string nearest = did_you_mean(word, candidates);
    std::string all;
    for (const std::string_view candidate : candidates)
      all.append(all.empty() ? "" : ", ").append(candidate);
    reject("no " + what + " has that name" + (nearest.empty() ? "; there are " + all : nearest));
  }

 private:
  std::string in_unit() const { return unit_.empty() ? "" : ", in " + std::string(unit_); }

  const Reading* reading_;
  std::string pointer_;
  const nlohmann::json* json_;
  std::string_view unit_;
};

/// An object whose keys are known: none but those of its table, and all that are required.
class Object {
 public:
  Object(Value value, const ObjectKeys& kind) : value_(std::move(value)), kind_(kind) {
    if (!value_.is_object()) value_.reject("it must be an object: " + with_article(kind_.name));
    std::vector<std::string_view> names;
    for (const Key& key : kind_.keys) names.push_back(key.name);
    for (const auto& [name, json] : value_.json().items())
      if (std::find(names.begin(), names.end(), name) == names.end())
        throw SceneError(value_.reading().file, pointer_to(value_.pointer(), name),
                         "is no key of " + with_article(kind_.name) + did_you_mean(name, names));
    require_keys();
  }

  const Value& value() const { return value_; }
  std::string_view kind() const { return kind_.name; }
  bool has(std::string_view key) const { return value_.json().contains(key); }

  Value operator[](std::string_view key) const {
    const auto found = std::find_if(kind_.keys.begin(), kind_.keys.end(),
                                    [&](const Key& known) { return known.name == key; });
    return {value_.reading(), pointer_to(value_.pointer(), key), value_.json().at(key),
            found->unit};
  }
  double number(std::string_view key, double otherwise) const {
    return has(key) ? (*this)[key].number() : otherwise;
  }
  double not_negative(std::string_view key, double otherwise) const {
    return has(key) ? (*this)[key].not_negative() : otherwise;
  }
  std::string text(std::string_view key, const std::string& otherwise) const {
    return has(key) ? (*this)[key].text() : otherwise;
  }
  bool boolean(std::string_view key) const { return has(key) && (*this)[key].boolean(); }
  Vec3d vector(std::string_view key, const Vec3d& otherwise = Vec3d::Zero()) const {
    return has(key) ? (*this)[key].vector() : otherwise;
  }
  /// Throws if one of the keys is there; `why` says why it can't be.
  void forbid(std::initializer_list<std::string_view> names, const std::string& why) const {
    for (const std::string_view key : names)
      if (has(key)) (*this)[key].reject(why);
  }
  /// The one of the two keys that is there.
  Value one_of(std::string_view first, std::string_view second) const {
    if (has(first) == has(second))
      value_.fail("needs either " + std::string(first) + " or " + std::string(second) +
                  (has(first) ? ", not both" : ""));
    return (*this)[has(first) ? first : second];
  }

 private:
  /// Throws with all the keys that are missing.
  void require_keys() const {
    std::string missing;
    int count = 0;
    for (const Key& key : kind_.keys) {
      if (!key.required || has(key.name)) continue;
      if (++count > 1) missing += "; ";
      missing += key.name;
      if (!key.unit.empty()) missing.append(", in ").append(key.unit);
    }
    if (count > 0) value_.fail((count > 1 ? "needs the keys " : "needs the key ") + missing);
  }

  Value value_;
  ObjectKeys kind_;
};

/// An object that says by `key` of which kind it is, such as a solid by its shape.
template <std::size_t count>
Object object_of_kind(const Value& value, const std::string& what, const std::string& key,
                      const std::array<ObjectKeys, count>& kinds) {
  if (!value.is_object()) value.reject("it must be an object: " + with_article(what));
  if (!value.json().contains(key))
    value.fail("needs the key " + key + ": which " + what + " is it?");
  std::array<std::string_view, count> names;
  for (std::size_t i = 0; i < count; ++i) names[i] = kinds[i].name;
  const Value name(value.reading(), pointer_to(value.pointer(), key), value.json().at(key));
  return {value, kinds[name.one_of(what, names)]};
}

/// An object of one of the kinds that need no key to be told apart.
inline Object object_called(const Value& value, std::string_view name) {
  const auto kind = std::find_if(object_kinds.begin(), object_kinds.end(),
                                 [&](const ObjectKeys& known) { return known.name == name; });
  return {value, *kind};
}

}  // namespace tumble
