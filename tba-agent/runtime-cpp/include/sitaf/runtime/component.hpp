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

/// Makes a component, sets its properties and leads it through its life, by what its class offers.
namespace sitaf::runtime {
namespace detail {

template <class Wanted, class... Offered>
constexpr bool isOffered = (std::is_same_v<std::remove_cv_t<Wanted>, Offered> || ...);

/// Stands for any argument of a constructor, and becomes the object at hand that the parameter is of: by reference, pointer or shared
/// pointer. To all other types it converts in no way, so that the constructor is not one to call.
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
  /// The object is not the pointer's own: it lives as long as the test.
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

/// A property's value, which becomes what the setter takes.
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

/// Makes a component. Of its public constructors the one with the most parameters is taken that asks for nothing but the objects at hand,
/// each by its type: a reference, a pointer or a shared pointer.
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

/// Where the name of a property gives no setter.
struct NoSetter {};

/// Sets a property by `setProperty(name, value)` where the class has it, else by the setter of its name, which the last argument calls with
/// the value made into the type of its parameter. A value that does not fit is a std::invalid_argument.
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

/// What a component has of a name: a method without parameters, or a public member.
#define SITAF_METHOD(name) [](auto& component) -> decltype(component.name()) { return component.name(); }
#define SITAF_MEMBER(name) [](auto& component) -> decltype((component.name)) { return (component.name); }

/// What a component last sent through an output data port: the method of the port's name or its getter, else the public member of its
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

/// Methods of a component's interfaces that are for the test to call, and are no hooks.
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

/// Calls the first of several hooks that a component has; whether it has one.
template <class Component, template <class, class> class... Hooks>
bool callFirst(Component& component, const NotHooks& notHooks) {
  return (Hooks<Component, void>::call(component, notHooks) || ...);
}
}  // namespace detail
#undef SITAF_HOOK

/// Begins the life of a component that was made: `initialise` and `start` (or `initialize`, `onInitialize`, `onStart`), where it has them.
template <class Component>
void beginLife(Component& component, const NotHooks& notHooks) {
  detail::callFirst<Component, detail::Initialise, detail::Initialize, detail::OnInitialize>(component, notHooks);
  detail::callFirst<Component, detail::Start, detail::OnStart>(component, notHooks);
}

/// Ends the life of a component: `stop` and `destroy` (or `onStop`, `onDestroy`), where it has them.
template <class Component>
void endLife(Component& component, const NotHooks& notHooks) {
  detail::callFirst<Component, detail::Stop, detail::OnStop>(component, notHooks);
  detail::callFirst<Component, detail::Destroy, detail::OnDestroy>(component, notHooks);
}

/// One period of a periodic component: `onExecute` or `execute`.
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
