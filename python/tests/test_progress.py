# SPDX-License-Identifier: GPL-3.0-or-later
"""Progress, ends before the end, and several threads."""

import os
import signal
import subprocess
import sys
import threading
import time
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest
from meshes import hourglass, read_off

import constrictions

STAGES = ["simplification", "seeds", "refinement", "tightening", "certification", "selection"]


@pytest.fixture(scope="module")
def hand():
    return constrictions.Surface(*read_off("hand.off"))


def same(found, other):
    a, b = found.as_dict(), other.as_dict()
    return all(np.array_equal(a[name], b[name], equal_nan=a[name].dtype.kind == "f") for name in a)


def test_progress_is_told_in_order(hand):
    calls = []
    hand.detect(progress=lambda *call: calls.append(call))
    stages = [stage for stage, _, _ in calls]
    assert sorted(set(stages), key=STAGES.index) == STAGES
    assert stages == sorted(stages, key=STAGES.index)
    for stage in STAGES:
        done = [d for s, d, _ in calls if s == stage]
        assert done == sorted(done)
    assert all(0 <= done <= steps for _, done, steps in calls)


def test_progress_is_told_by_the_thread_that_calls(hand):
    threads = set()
    hand.detect(progress=lambda *_: threads.add(threading.get_ident()))
    assert threads == {threading.get_ident()}


def test_progress_of_tightening():
    surface = constrictions.Surface(*hourglass())
    calls = []
    surface.tighten([range(36, 48)] * 5, progress=lambda *call: calls.append(call))
    assert calls[-1] == ("tightening", 5, 5)


def test_what_progress_raises_ends_the_search(hand):
    class Enough(Exception):
        pass

    for stage in STAGES[:2]:
        error = Enough(stage)

        def stop(current, done, steps):
            if current == stage:
                raise error

        with pytest.raises(Enough) as raised:
            hand.detect(progress=stop)
        assert raised.value is error
    # and leaves the surface as it was
    assert len(hand.detect(all=True, max_number=2)) == 2


def test_progress_that_is_wrong_is_told():
    surface = constrictions.Surface(*hourglass())
    with pytest.raises(TypeError, match="progress can not be called"):
        surface.detect(progress=3)
    with pytest.raises(TypeError, match="positional argument"):
        surface.detect(progress=lambda: None)


def test_progress_can_call_the_surface_itself(hand):
    other = constrictions.Surface(*hourglass())
    found = []
    hand.detect(progress=lambda *_: found or found.append(other.detect()))
    assert len(found[0]) == 1


def test_other_threads_run_meanwhile(hand):
    ticks = []
    done = threading.Event()

    def tick():
        while not done.wait(0.005):
            ticks.append(time.monotonic())

    thread = threading.Thread(target=tick)
    thread.start()
    begin = time.monotonic()
    hand.detect()
    end = time.monotonic()
    done.set()
    thread.join()
    inside = [t for t in ticks if begin < t < end]
    assert len(inside) > 5


def test_several_threads_find_what_one_finds(hand):
    expected = hand.detect(all=True)
    place = expected[0].centroid
    expected_near = hand.near(place)
    expected_parts = hand.segment(expected[:5])
    expected_split = hand.split(expected[:5])
    with ThreadPoolExecutor(4) as pool:
        several = [pool.submit(hand.detect, all=True) for _ in range(2)]
        near = pool.submit(hand.near, place)
        parts = [pool.submit(hand.segment, expected[:5]) for _ in range(4)]
        splits = [pool.submit(hand.split, expected[:5]) for _ in range(4)]
    for future in several:
        assert same(future.result(), expected)
    assert same(near.result(), expected_near)
    for future in parts:
        assert np.array_equal(future.result().labels, expected_parts.labels)
    for future in splits:
        assert np.array_equal(future.result().vertices, expected_split.vertices)
        assert np.array_equal(future.result().faces, expected_split.faces)


INTERRUPTED = """
import os, signal, sys, threading, time
sys.path.insert(0, {tests!r})
from meshes import read_off
import constrictions
surface = constrictions.Surface(*read_off("armadillo.off"))
stages = []
def progress(stage, done, steps):
    if not stages:
        threading.Timer(0.05, os.kill, (os.getpid(), signal.SIGINT)).start()
    stages.append(stage)
begin = time.monotonic()
try:
    surface.detect({progress})
except KeyboardInterrupt:
    print("interrupted", time.monotonic() - begin)
else:
    print("done", time.monotonic() - begin)
"""


def test_ctrl_c_ends_the_search():
    read_off("armadillo.off")
    script = INTERRUPTED.format(tests=os.path.dirname(__file__), progress="progress=progress")
    process = subprocess.run([sys.executable, "-c", script], stdout=subprocess.PIPE, check=True, timeout=120)
    word, seconds = process.stdout.split()
    assert word == b"interrupted" and float(seconds) < 20


def test_a_handler_of_signals_can_go_on(hand):
    calls = []
    before = signal.signal(signal.SIGALRM, lambda *_: calls.append(True))
    try:
        signal.setitimer(signal.ITIMER_REAL, 0.02)
        assert len(hand.detect(all=True, max_number=1)) == 1
    finally:
        signal.signal(signal.SIGALRM, before)
    assert calls == [True]
