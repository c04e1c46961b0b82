# SPDX-License-Identifier: BSD-3-Clause
"""Bring filters up to date: progress, Ctrl-C, errors as exceptions, warnings as warnings."""

import os
import signal
import sys
import threading
import warnings

from vtkmodules.vtkCommonCore import VTK_STRING

PACKAGE = os.path.dirname(os.path.abspath(__file__))


def upstream(algorithm):
    """An algorithm and all that feed it, those that run first in front."""
    found = []

    def visit(one):
        if one not in found:
            for port in range(one.GetNumberOfInputPorts()):
                for index in range(one.GetNumberOfInputConnections(port)):
                    visit(one.GetInputConnection(port, index).GetProducer())
            if one not in found:
                found.append(one)

    visit(algorithm)
    return found


def sentence(text):
    """What VTK says, without the place in its sources."""
    said = text.split("): ", 1)[-1].strip()
    name = text.split(" (0x", 1)[0].rsplit(None, 1)[-1] if " (0x" in text else ""
    return f"{name}: {said}" if name.startswith("vtk") else said


def warn(message):
    """warnings.warn, told of the caller's line and not of one of ours."""
    depth, frame = 2, sys._getframe(1)
    while frame is not None and os.path.dirname(os.path.abspath(frame.f_code.co_filename)) == PACKAGE:
        depth, frame = depth + 1, frame.f_back
    warnings.warn(message, RuntimeWarning, stacklevel=depth)


class Lines:
    """Progress on standard error: a bar that is drawn again on a terminal, else a line at every tenth."""

    def __init__(self, stream=None):
        self.stream = stream or sys.stderr
        self.drawn = -1

    def __call__(self, fraction):
        percent = int(100 * fraction)
        if self.stream.isatty():
            if percent != self.drawn:
                bar = "#" * (percent * 40 // 100)
                self.stream.write(f"\r[{bar:<40}] {percent:3d} %" + ("\n" if percent == 100 else ""))
                self.stream.flush()
                self.drawn = percent
        elif percent // 10 > self.drawn:
            self.drawn = percent // 10
            self.stream.write(f"{percent:3d} %\n")


class Tqdm:
    """Progress by tqdm."""

    def __init__(self, tqdm):
        self.bar = tqdm(total=100, unit="%", leave=False)

    def __call__(self, fraction):
        self.bar.update(int(100 * fraction) - self.bar.n)
        if fraction >= 1:
            self.bar.close()


def listener(progress):
    """What `progress` means: nothing, a call with a fraction from 0 to 1, or True for a bar."""
    if progress is None or progress is False:
        return None
    if progress is True:
        try:
            from tqdm.auto import tqdm
        except ImportError:
            return Lines()
        return Tqdm(tqdm)
    if not callable(progress):
        raise TypeError("progress must be True or something to call with a fraction from 0 to 1")
    return progress


class Run:
    """One update of a chain of filters."""

    def __init__(self, algorithm, progress):
        self.algorithm = algorithm
        self.chain = upstream(algorithm)
        self.progress = listener(progress)
        self.told = 0.0
        self.errors, self.warnings = [], []
        self.interrupted = False
        self.fault = None

    def stop(self):
        for one in self.chain:
            one.SetAbortExecute(1)

    def tell(self, fraction):
        """Call the listener. What it raises is raised at the end: an observer that raises would end the process."""
        if self.progress is None or self.fault is not None or fraction <= self.told:
            return
        self.told = fraction
        try:
            self.progress(fraction)
        except BaseException as fault:
            self.fault = fault
            self.stop()

    def observe(self):
        """Observers of every filter. Python's own handlers of signals run while one of them does."""
        tags = []
        for index, one in enumerate(self.chain):
            def move(filter_, _event, index=index):
                if self.interrupted or self.fault:
                    self.stop()  # filters begin with the flag cleared
                self.tell((index + min(max(filter_.GetProgress(), 0.0), 1.0)) / len(self.chain))

            tags.append((one, one.AddObserver("ProgressEvent", move)))
            for speaker in (one, one.GetExecutive()):
                for event, said in (("ErrorEvent", self.errors), ("WarningEvent", self.warnings)):
                    def hear(_object, _event, text="", said=said):
                        said.append(sentence(text))

                    hear.CallDataType = VTK_STRING
                    tags.append((speaker, speaker.AddObserver(event, hear)))
        return tags

    def interrupt(self, _signal, _frame):
        self.interrupted = True
        self.stop()

    def update(self):
        main = threading.current_thread() is threading.main_thread()
        before = signal.getsignal(signal.SIGINT) if main else None
        ours = main and before not in (None, signal.SIG_IGN)
        tags = self.observe()
        if ours:
            signal.signal(signal.SIGINT, self.interrupt)
        try:
            self.algorithm.Update()
        finally:
            if ours:
                signal.signal(signal.SIGINT, before)
            for speaker, tag in tags:
                speaker.RemoveObserver(tag)
            for one in self.chain:
                one.SetAbortExecute(0)
        self.report()
        self.tell(1.0)
        if self.fault is not None:
            raise self.fault

    def report(self):
        if self.interrupted:
            raise KeyboardInterrupt
        if self.fault is not None:
            raise self.fault
        if self.errors:
            # The executive says after each that the request failed: the first one knows why.
            raise (RuntimeError if " failed: " in self.errors[0] else ValueError)(self.errors[0])
        for message in dict.fromkeys(self.warnings):
            warn(message)


def update(algorithm, progress=None):
    """Bring an algorithm up to date.

    Errors of it and of what feeds it are raised: ValueError for what was given, RuntimeError for what went wrong inside.
    Warnings are warnings of Python. Ctrl-C stops the filters and raises KeyboardInterrupt.
    """
    Run(algorithm, progress).update()
    return algorithm
