#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# oneTBB 2021.8.0 (libtbb-dev 2021.8.0-2+deb12u1) where it meets CGAL 5.5.1 (libcgal-dev 5.5.1-2): parallel_for() inside
# a scope of Protect_FPU_rounding.
#
# Guess: the calling thread keeps its rounding mode while it works on tasks; if anything is lost, it is lost in the
# other threads.
# What happens: the scheduler remembers the floating-point settings of the moment when the thread first used it, and
# sets them for each task, on every thread, the caller's too. A program that has used oneTBB once and then asks for
# upward rounding and calls parallel_for() computes all tasks with rounding to the nearest; after the call the mode is
# upward again, so that a check before and after sees nothing. Interval_nt<false> then claims that 1 / 3 is one double,
# an interval of width zero that does not contain it. If the first use of oneTBB in the thread is inside the scope,
# everything is right: the same function is right or wrong depending on what ran before. capture_fp_settings() of a
# context gives tasks the mode of the caller.
#
# Why it matters: interval filters of exact predicates, as in the proof that a curve is straight, must set the rounding
# mode inside each task; set around the loop they prove things that are not so. The sign prover of this package sets it
# around each sign.
. "$(dirname "$0")/lib/packages.sh"
debian libtbb-dev=2021.8.0-2+deb12u1 libcgal-dev=5.5.1-2 libgmp-dev libmpfr-dev

cat > "$work/rounding.cpp" << 'END'
#include <CGAL/Interval_nt.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_group.h>
#include <atomic>
#include <cstdio>
#include <thread>

typedef CGAL::Interval_nt<false> Interval;

// Computes 1 / 3 in parallel, with upward rounding around the loop.
void run(const char* name, bool capture)
{
  const std::thread::id caller = std::this_thread::get_id();
  std::atomic<int> of_caller(0), of_others(0), narrow_of_caller(0), narrow_of_others(0);
  CGAL::Protect_FPU_rounding<true> upward;
  tbb::task_group_context context;
  if(capture)
    context.capture_fp_settings();
  tbb::parallel_for(tbb::blocked_range<int>(0, 400, 1), [&](const tbb::blocked_range<int>&) {
    volatile double numerator = 1, denominator = 3;
    const Interval third = Interval(numerator) / Interval(denominator);
    const bool narrow = third.inf() == third.sup();
    const bool mine = std::this_thread::get_id() == caller;
    ++(mine ? of_caller : of_others);
    (mine ? narrow_of_caller : narrow_of_others) += narrow;
    std::this_thread::sleep_for(std::chrono::microseconds(300));
  }, context);
  const auto share = [](int part, int all) { return part == 0 ? "none" : part == all ? "all" : "some"; };
  std::printf("%s: width zero for %s of the caller's tasks, %s of the others'; afterwards upward: %s\n", name,
              share(narrow_of_caller, of_caller), share(narrow_of_others, of_others),
              CGAL::FPU_get_cw() == CGAL_FE_UPWARD ? "yes" : "no");
}

int main(int argc, char*[])
{
  tbb::global_control threads(tbb::global_control::max_allowed_parallelism, 4);
  if(argc == 1)
  {
    run("first use of oneTBB", false);
    return 0;
  }
  tbb::parallel_for(0, 100, [](int) {});
  run("used before", false);
  run("used before, settings captured", true);
}
END
compile rounding tbb mpfr gmp
verdict "$("$work/rounding"; "$work/rounding" used)" \
"first use of oneTBB: width zero for none of the caller's tasks, none of the others'; afterwards upward: yes
used before: width zero for all of the caller's tasks, all of the others'; afterwards upward: yes
used before, settings captured: width zero for none of the caller's tasks, none of the others'; afterwards upward: yes"
