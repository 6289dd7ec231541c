// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CONSTRICTIONS_HELD_SIGNALS_H
#define CONSTRICTIONS_HELD_SIGNALS_H

#include <csignal>

#include <array>
#include <cstddef>

namespace constrictions {

/// While one lives SIGINT, SIGTERM and SIGHUP wait; then they do what they did before. No two live at a time.
class Held_signals
{
public:
  Held_signals()
  {
    s_caught = 0;
    for(std::size_t i = 0; i < m_before.size(); ++i)
    {
      sigaction(signals[i], nullptr, &m_before[i]);
      struct sigaction action = {};
      action.sa_handler = [](int signal) { s_caught = signal; };
      if(m_before[i].sa_handler != SIG_IGN)
        sigaction(signals[i], &action, nullptr);
    }
  }

  ~Held_signals()
  {
    for(std::size_t i = 0; i < m_before.size(); ++i)
      sigaction(signals[i], &m_before[i], nullptr);
    if(s_caught != 0)
      std::raise(s_caught);
  }

  Held_signals(const Held_signals&) = delete;
  Held_signals& operator=(const Held_signals&) = delete;

private:
  static constexpr std::array<int, 3> signals = {{SIGINT, SIGTERM, SIGHUP}};
  inline static volatile std::sig_atomic_t s_caught = 0;
  std::array<struct sigaction, 3> m_before;
};

} // namespace constrictions

#endif // CONSTRICTIONS_HELD_SIGNALS_H
