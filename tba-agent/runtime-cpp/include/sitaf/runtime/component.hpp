#pragma once

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "sitaf/runtime/cannot_run.hpp"
#include "sitaf/suite/literals.hpp"

/// Creates a component, sets its properties and calls its life-cycle methods, depending on the members of its class.
namespace sitaf::runtime {
namespace detail {

template <class Wanted, class... Offered>
constexpr bool isOffered = (std::is_same_v<std::remove_cv_t<Wanted>, Offered> || ...);

/// An argument for any parameter of a constructor. It converts to each available object, as a reference, pointer or shared pointer, and to
/// no other type, so that std::is_constructible tells which constructors can be called.
template <class... Offered>
class Offer {
 public:
  explicit Offer(Offered&... objects) : objects_(&objects...) {}

  template <class Wanted, std::enable_if_t<isOffered<Wanted, Offered...>, int> = 0>
  operator Wanted&() const {
    return *std::get<std::remove_cv_t<Wanted>*>(objects_);
  }
  template <class Wanted, std::enable_if_t<isOffered<Wanted, Offered...>, int> = 0>
  operator Wanted*() const {
    return std::get<std::remove_cv_t<Wanted>*>(objects_);
  }
  /// A non-owning pointer; the object lives as long as the test.
  template <class Wanted, std::enable_if_t<isOffered<Wanted, Offered...>, int> = 0>
  operator std::shared_ptr<Wanted>() const {
    return std::shared_ptr<Wanted>(std::shared_ptr<void>(), std::get<std::remove_cv_t<Wanted>*>(objects_));
  }

 private:
  std::tuple<Offered*...> objects_;
};

template <class Component, class Argument, std::size_t... Index>
constexpr bool takes(std::index_sequence<Index...> /*count*/) {
  return std::is_constructible_v<Component, std::enable_if_t<Index + 1 != 0, const Argument&>...>;
}

template <class Component, class Argument, std::size_t... Index>
std::unique_ptr<Component> make(const Argument& argument, std::index_sequence<Index...> /*count*/) {
  return std::make_unique<Component>(((void)Index, argument)...);
}

/// The value of a property, which converts to the parameter type of the setter.
class PropertyText {
 public:
  PropertyText(std::string name, std::string text) : name_(std::move(name)), text_(std::move(text)) {}

  template <class Wanted, std::enable_if_t<std::is_arithmetic_v<Wanted> || std::is_same_v<Wanted, std::string>, int> = 0>
  operator Wanted() const {
    try {
      return suite::literals::read<Wanted>(text_);
    } catch (const suite::CaseDataError& e) {
      throw std::invalid_argument("the property '" + name_ + "' of activity.yaml: " + e.what());
    }
  }

 private:
  std::string name_;
  std::string text_;
};

template <class Component, class = void>
struct HasSetProperty : std::false_type {};
template <class Component>
struct HasSetProperty<
    Component, std::void_t<decltype(std::declval<Component&>().setProperty(std::declval<std::string>(), std::declval<std::string>()))>>
    : std::true_type {};

template <class...>
constexpr bool never = false;

}  // namespace detail

/// Creates a component with the public constructor that has the most parameters and whose parameters are all references, pointers or
/// shared pointers to available objects.
template <class Component, class... Offered>
std::unique_ptr<Component> createComponent(Offered&... offered) {
  static_assert(!std::is_abstract_v<Component>,
                "the component under test is abstract: it lacks a method of its base, or activity.yaml names an interface as its class");
  using Argument = detail::Offer<Offered...>;
  const Argument argument(offered...);
  constexpr bool three = detail::takes<Component, Argument>(std::make_index_sequence<3>());
  if constexpr (detail::takes<Component, Argument>(std::make_index_sequence<6>())) {
    return detail::make<Component>(argument, std::make_index_sequence<6>());
  } else if constexpr (detail::takes<Component, Argument>(std::make_index_sequence<5>())) {
    return detail::make<Component>(argument, std::make_index_sequence<5>());
  } else if constexpr (detail::takes<Component, Argument>(std::make_index_sequence<4>())) {
    return detail::make<Component>(argument, std::make_index_sequence<4>());
  } else if constexpr (three) {
    return detail::make<Component>(argument, std::make_index_sequence<3>());
  } else if constexpr (detail::takes<Component, Argument>(std::make_index_sequence<2>())) {
    return detail::make<Component>(argument, std::make_index_sequence<2>());
  } else if constexpr (detail::takes<Component, Argument>(std::make_index_sequence<1>())) {
    return detail::make<Component>(argument, std::make_index_sequence<1>());
  } else if constexpr (std::is_default_constructible_v<Component>) {
    return std::make_unique<Component>();
  } else {
    static_assert(detail::never<Component>,
                  "the component under test has no public constructor that takes any of: sitaf::Hardware (where activity.yaml names a "
                  "world), the required interfaces; nor one without parameters");
  }
}

/// A setter, for setProperty.
#define SITAF_SETTER(name) [](auto& component, const auto& value) -> decltype(component.name(value)) { return component.name(value); }

/// Used when no setter can be derived from the name of a property.
struct NoSetter {};

/// Sets a property with `setProperty(name, value)` if the class has this method, otherwise with the setter of its name. The last argument
/// calls the setter and converts the value to its parameter type. A value that cannot be converted throws std::invalid_argument.
template <class Component, class Setter>
void setProperty(Component& component, const char* name, const char* value, Setter setter) {
  if constexpr (detail::HasSetProperty<Component>::value) {
    component.setProperty(std::string(name), std::string(value));
  } else {
    static_assert(std::is_invocable_v<Setter, Component&, const detail::PropertyText&>,
                  "the component under test has neither setProperty(name, value) nor the setter of a property that activity.yaml names, "
                  "with one parameter that is a number, a bool or a string");
    setter(component, detail::PropertyText(name, value));
  }
}

/// A member of a component by its name: a method without parameters, or a public data member.
#define SITAF_METHOD(name) [](auto& component) -> decltype(component.name()) { return component.name(); }
#define SITAF_MEMBER(name) [](auto& component) -> decltype((component.name)) { return (component.name); }

/// Reads the last value of an output data port, from the method with the port's name, its getter, or the public data member with its
/// name.
template <class Component, class Method, class Getter, class Member>
decltype(auto) dataPort(Component& component, Method method, Getter getter, Member member) {
  if constexpr (std::is_invocable_v<Method, Component&>) {
    return method(component);
  } else if constexpr (std::is_invocable_v<Getter, Component&>) {
    return getter(component);
  } else {
    static_assert(std::is_invocable_v<Member, Component&>,
                  "the component under test has neither a method of the name of the data port that the model observes, nor a getter, nor a "
                  "public member of that name");
    return member(component);
  }
}

/// Methods of a component's interfaces. The test calls them, so they are never called as hooks.
using NotHooks = std::vector<std::string_view>;

#define SITAF_HOOK(Hook, method)                                                                        \
  template <class Component, class = void>                                                              \
  struct Hook : std::false_type {                                                                       \
    static bool call(Component&, const NotHooks&) { return false; }                                     \
  };                                                                                                    \
  template <class Component>                                                                            \
  struct Hook<Component, std::void_t<decltype(std::declval<Component&>().method())>> : std::true_type { \
    static bool call(Component& component, const NotHooks& notHooks) {                                  \
      if (std::find(notHooks.begin(), notHooks.end(), #method) != notHooks.end()) {                     \
        return false;                                                                                   \
      }                                                                                                 \
      component.method();                                                                               \
      return true;                                                                                      \
    }                                                                                                   \
  }

namespace detail {
SITAF_HOOK(Initialise, initialise);
SITAF_HOOK(Initialize, initialize);
SITAF_HOOK(OnInitialize, onInitialize);
SITAF_HOOK(Start, start);
SITAF_HOOK(OnStart, onStart);
SITAF_HOOK(Stop, stop);
SITAF_HOOK(OnStop, onStop);
SITAF_HOOK(Destroy, destroy);
SITAF_HOOK(OnDestroy, onDestroy);
SITAF_HOOK(OnExecute, onExecute);
SITAF_HOOK(Execute, execute);

/// Calls the first of several hooks that the component has; returns whether it has one.
template <class Component, template <class, class> class... Hooks>
bool callFirst(Component& component, const NotHooks& notHooks) {
  return (Hooks<Component, void>::call(component, notHooks) || ...);
}
}  // namespace detail
#undef SITAF_HOOK

/// Initialises and starts a component: `initialise` and `start` (or `initialize`, `onInitialize`, `onStart`), if it has them.
template <class Component>
void beginLife(Component& component, const NotHooks& notHooks) {
  detail::callFirst<Component, detail::Initialise, detail::Initialize, detail::OnInitialize>(component, notHooks);
  detail::callFirst<Component, detail::Start, detail::OnStart>(component, notHooks);
}

/// Stops a component: `stop` and `destroy` (or `onStop`, `onDestroy`), if it has them.
template <class Component>
void endLife(Component& component, const NotHooks& notHooks) {
  detail::callFirst<Component, detail::Stop, detail::OnStop>(component, notHooks);
  detail::callFirst<Component, detail::Destroy, detail::OnDestroy>(component, notHooks);
}

/// Executes one period of a periodic component: `onExecute` or `execute`.
template <class Component>
void execute(Component& component, const NotHooks& notHooks) {
  static_assert(detail::OnExecute<Component>::value || detail::Execute<Component>::value,
                "activity.yaml says that the component is periodic, but it has neither onExecute() nor execute()");
  if (!detail::callFirst<Component, detail::OnExecute, detail::Execute>(component, notHooks)) {
    throw CannotRun(
        "activity.yaml says that the component is periodic, but its onExecute() or execute() is a method of the interface, which only the "
        "test calls");
  }
}

}  // namespace sitaf::runtime
