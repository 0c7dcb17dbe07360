#pragma once

#include <memory>
#include <string>
#include <utility>

#include "diagnostic_updater/update_functions.hpp"

namespace diagnostic_updater {

/// Watches how often something is published.
class HeaderlessTopicDiagnostic : public CompositeDiagnosticTask
{
public:
  HeaderlessTopicDiagnostic(
    std::string name, Updater & updater, const FrequencyStatusParam & frequency,
    rclcpp::Clock::SharedPtr clock = std::make_shared<rclcpp::Clock>())
  : CompositeDiagnosticTask(name + " topic status"), frequency_(frequency, "FrequencyStatus", std::move(clock))
  {
    addTask(&frequency_);
    updater.add(*this);
  }
  ~HeaderlessTopicDiagnostic() override = default;
  virtual void tick() {frequency_.tick();}
  virtual void clear_window() {frequency_.clear();}

private:
  FrequencyStatus frequency_;
};

/// Watches the stamps, too.
class TopicDiagnostic : public HeaderlessTopicDiagnostic
{
public:
  TopicDiagnostic(
    std::string name, Updater & updater, const FrequencyStatusParam & frequency, const TimeStampStatusParam & stamp,
    rclcpp::Clock::SharedPtr clock = std::make_shared<rclcpp::Clock>())
  : HeaderlessTopicDiagnostic(std::move(name), updater, frequency, clock), stamp_(stamp, "Timestamp Status", clock)
  {
    addTask(&stamp_);
  }
  void tick() override {throw std::runtime_error("tick(void) has been called on a TopicDiagnostic");}
  virtual void tick(const rclcpp::Time & stamp)
  {
    stamp_.tick(stamp);
    HeaderlessTopicDiagnostic::tick();
  }

private:
  TimeStampStatus stamp_;
};

/// A publisher whose messages, which have a header, are watched.
template<class M, class A = std::allocator<void>>
class DiagnosedPublisher : public TopicDiagnostic
{
public:
  using PublisherT = rclcpp::Publisher<M, A>;
  DiagnosedPublisher(
    const typename PublisherT::SharedPtr & publisher, Updater & updater, const FrequencyStatusParam & frequency,
    const TimeStampStatusParam & stamp, rclcpp::Clock::SharedPtr clock = std::make_shared<rclcpp::Clock>())
  : TopicDiagnostic(publisher->get_topic_name(), updater, frequency, stamp, std::move(clock)), publisher_(publisher) {}
  virtual void publish(typename PublisherT::MessageUniquePtr message)
  {
    tick(rclcpp::Time(message->header.stamp));
    publisher_->publish(std::move(message));
  }
  virtual void publish(const std::shared_ptr<M> & message) {publish(*message);}
  virtual void publish(const M & message)
  {
    tick(rclcpp::Time(message.header.stamp));
    publisher_->publish(message);
  }
  typename PublisherT::SharedPtr publisher() const {return publisher_;}
  void setPublisher(typename PublisherT::SharedPtr publisher) {publisher_ = std::move(publisher);}

private:
  typename PublisherT::SharedPtr publisher_;
};

}  // namespace diagnostic_updater
