"""Running programs in a case: logs as they come, a longest time, changes of
dictionaries."""

import os
from time import sleep

import pytest

from cosserat.case import Case, RunError
from cosserat.scenes.box import TWO

DICTIONARY = """a 1;
sub { b 2; c 3; }
// end
"""


@pytest.fixture(name="case")
def case_fixture(tmp_path):
    """A folder with a dictionary, whose programs may take two seconds."""
    case = Case(tmp_path)
    case.timeout = 2
    (tmp_path/"system").mkdir()
    (tmp_path/"system/controlDict").write_text(DICTIONARY)
    return case


def gone(pid):
    """Does a process end that was killed: at once, but for the system's time
    to do it."""
    for _ in range(100):
        try:
            os.kill(pid, 0)
            with open(f"/proc/{pid}/stat", encoding="utf-8") as file:
                if file.read().split(")")[1].split()[0] == "Z":
                    return True
        except (ProcessLookupError, FileNotFoundError):
            return True
        sleep(0.1)
    return False


@pytest.mark.slow
def test_what_takes_too_long_is_killed(case):
    """With all that it has started; the message ends with its log."""
    with pytest.raises(RunError, match=r"(?s)killed after 2 s.*step 1"):
        case.run("sh", "-c", "echo step 1; sleep 600 & echo $! > child; wait")
    assert case.log("sh") == "step 1\n"
    assert gone(int((case.path/"child").read_text()))


@pytest.mark.slow
def test_ranks_are_killed(case):
    """Those that mpirun has started."""
    with pytest.raises(RunError, match="killed after"):
        case.run("sh", "-c", "echo $$ > pid.$OMPI_COMM_WORLD_RANK;"
                 " exec sleep 600", ranks=2)
    pids = [int(file.read_text()) for file in case.path.glob("pid.*")]
    assert len(pids) == 2 and all(gone(pid) for pid in pids)


def test_log_is_written_as_it_comes(case):
    """The program itself finds it there, before it ends."""
    done = case.run("sh", "-c", "echo one; wc -c < log.sh; echo two")
    assert done.stdout == case.log("sh") == "one\n4\ntwo\n"


def test_failure_tells_the_log(case):
    """Unless it is not checked; without a log there is no file."""
    with pytest.raises(RunError, match=r"(?s)ended with 3:.*oh"):
        case.run("sh", "-c", "echo oh; exit 3")
    done = case.run("sh", "-c", "exit 4", check=False, log=False)
    assert done.returncode == 4
    assert (case.path/"log.sh").read_text() == "oh\n"


def entry(case, key):
    """What OpenFOAM reads."""
    return case.run("foamDictionary", "system/controlDict", "-entry", key,
                    "-value", log=False).stdout.split()[-1]


def test_override(case):
    """What comes later prevails; dictionaries merge."""
    case.timeout = 600
    case.override("control", a=7, sub="{ b 5; }", d="word")
    assert [entry(case, key) for key in ("a", "sub/b", "sub/c", "d")] == [
        "7", "5", "3", "word"]


def test_substitute(case):
    """Each entry has to be there."""
    case.timeout = 600
    case.substitute("system/controlDict", {"a": 9})
    assert entry(case, "a") == "9"
    with pytest.raises(KeyError, match="no entry e"):
        case.substitute("system/controlDict", {"e": 1})


def test_a_box_in_place_of_another(box):
    """Its fields are of its own mesh."""
    for n in (4, 6):
        case = box(n=n, materials=TWO, fractions=lambda x, y: (x > 0)*1.0)
        assert len(case.field("alpha.a", "0")) == n*n
