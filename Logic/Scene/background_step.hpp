#pragma once

#include "Scene/plan_step.hpp"

#include <condition_variable>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>

/// How is a step done in a thread that must not touch the scene?
namespace f2b
{

/// Thrown through a step when it is cancelled.
struct Cancelled
{
};

/// A step in its own thread. What it has to tell waits here until the owner of the scene looks.
class BackgroundStep
{
public:
  explicit BackgroundStep(StepRequest request);
  ~BackgroundStep(); ///< cancels and waits

  const StepRequest& request() const { return m_request; }
  void cancel();

  struct News
  {
    double fraction = 0;
    std::string text;
    bool finished = false;
  };
  /// Progress; answers the thread's question for the hook's work with `hook`.
  News look(const CommitHook& hook);
  /// Once finished: rethrows what ended the step, if it failed.
  void finish();

private:
  void work();
  void tell(std::string_view what, double fraction);
  void ask(const CaseOutlook& outlook);

  StepRequest m_request;
  std::mutex m_mutex;
  std::condition_variable m_answered;
  News m_news;
  bool m_cancelled = false;
  const CaseOutlook* m_question = nullptr; ///< of the waiting thread
  std::exception_ptr m_answer, m_failure;
  std::thread m_thread; ///< last: it uses all of the above
};

} // namespace f2b
