# SPDX-License-Identifier: LGPL-2.1-or-later
"""Entry point, for Python and for freecadcmd: the last argument is the path of the job.

The job: {"reader", "file", "seconds", "memory", "path" (where modules are sought last), and what the reader wants}.
Leaves result.npz or fault.json in the job's folder.
"""
import importlib
import json
import os
import sys

READERS = {"mesh": "mesh", "med": "with_freecad", "solid": "with_freecad",
           "document": "with_freecad"}     # the module with read_<reader>(job)


def _main(job_path):
    folder = os.path.dirname(os.path.abspath(job_path))
    with open(job_path, encoding="utf-8") as stream:
        job = json.load(stream)
    workers = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
    if workers not in sys.path:
        sys.path.insert(0, workers)
    from file_worker import limits, refusal
    limits.keep_to(job["seconds"], job["memory"])
    sys.path.extend(p for p in job["path"] if p not in sys.path)
    with open(os.path.join(folder, "progress.txt"), "w", encoding="utf-8") as stream:
        stream.write("read 0\n")    # from here on it is the library that ends this process
    try:
        reader = importlib.import_module("file_worker." + READERS[job["reader"]])
        arrays = getattr(reader, "read_" + job["reader"])(job)
        import numpy
        numpy.savez(os.path.join(folder, "result.npz"), **arrays)
        return 0
    except refusal.Refusal as found:
        code, message, elements = found.code, str(found), found.elements
    except ImportError as error:
        code, message, elements = "TOOL_MISSING", f"this Python ({sys.executable}) has not what reads it: {error}", []
    except MemoryError:
        code, elements = "FILE_FORMAT", []
        message = f"it asks for more than {job['memory'] >> 20} MiB of memory; it is damaged, or too large for this machine"
    except OSError as error:
        code, message, elements = "FILE_IO", error.strerror or str(error), []
    except (Exception, SystemExit) as error:    # libraries raise what they like
        code, message, elements = "FILE_FORMAT", f"{type(error).__name__}: {error}", []
    with open(os.path.join(folder, "fault.json"), "w", encoding="utf-8") as stream:
        json.dump({"code": code, "message": message[:4000], "elements": elements}, stream)
    return 0


def guarded(job_path):
    """Exit status: 0 where the job left a result or a fault."""
    try:
        return _main(job_path)
    except BaseException:
        import traceback
        traceback.print_exc()
        return 1


if __name__ in ("__main__", "start"):   # "start": the name that freecadcmd gives a script
    status = guarded(sys.argv[-1])
    sys.stdout.flush()
    sys.stderr.flush()
    os._exit(status)    # without the libraries' own farewells; FreeCAD would run a script that raises a second time
