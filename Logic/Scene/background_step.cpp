#include "Scene/background_step.hpp"

namespace f2b
{

BackgroundStep::BackgroundStep(StepRequest request)
    : m_request(std::move(request)), m_thread([this] { work(); })
{
}

BackgroundStep::~BackgroundStep()
{
  cancel();
  if (m_thread.joinable())
    m_thread.join();
}

void BackgroundStep::cancel()
{
  const std::lock_guard<std::mutex> lock(m_mutex);
  m_cancelled = true;
  m_answered.notify_all();
}

void BackgroundStep::work()
{
  try
  {
    compute_step(
        m_request, [this](std::string_view what, double fraction) { tell(what, fraction); },
        [this](const CaseOutlook& outlook) { ask(outlook); });
  }
  catch (...)
  {
    m_failure = std::current_exception();
  }
  const std::lock_guard<std::mutex> lock(m_mutex);
  m_news.finished = true;
}

void BackgroundStep::tell(std::string_view what, double fraction)
{
  const std::lock_guard<std::mutex> lock(m_mutex);
  if (m_cancelled)
    throw Cancelled();
  m_news.text = what;
  m_news.fraction = fraction;
}

/// Waits until the owner of the scene has written the scene file.
void BackgroundStep::ask(const CaseOutlook& outlook)
{
  std::unique_lock<std::mutex> lock(m_mutex);
  m_question = &outlook;
  m_answered.wait(lock, [this] { return m_cancelled || !m_question; });
  if (m_question) // cancelled before anybody looked
  {
    m_question = nullptr;
    throw Cancelled();
  }
  if (m_answer)
    std::rethrow_exception(std::exchange(m_answer, nullptr));
}

BackgroundStep::News BackgroundStep::look(const CommitHook& hook)
{
  const std::lock_guard<std::mutex> lock(m_mutex);
  if (m_question)
  {
    try
    {
      hook(*m_question);
    }
    catch (...)
    {
      m_answer = std::current_exception();
    }
    m_question = nullptr;
    m_answered.notify_all();
  }
  return m_news;
}

void BackgroundStep::finish()
{
  m_thread.join();
  if (m_failure)
    std::rethrow_exception(m_failure);
}

} // namespace f2b
