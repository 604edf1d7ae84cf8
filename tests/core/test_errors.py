"""What is refused is told in one line, which the error makes of what it carries."""

import pickle

import pytest

from surfcmp_core.errors import InputError

ROW = "1 2 " + 50 * "x"


def whole() -> InputError:
    return InputError("two numbers", where=("a.xyz", "b.xyz"), row=ROW, hints=("add one",))


def test_the_line_names_files_fault_row_and_hints() -> None:
    quoted = repr("1 2 " + 33 * "x" + "...")
    assert str(whole()) == f"a.xyz and b.xyz: two numbers in the row {quoted}; add one"
    assert str(InputError("nothing")) == "nothing"


def test_a_file_is_named_once() -> None:
    nameless = InputError("nothing", hints=("look",))
    assert str(nameless.at("a.xyz")) == "a.xyz: nothing; look"
    assert str(nameless) == "nothing; look"
    assert nameless.at("a.xyz").at("b.xyz").where == ("a.xyz",)


def test_hints_come_one_after_another() -> None:
    assert str(whole().with_hints("and one")).endswith("; add one; and one")
    assert whole().with_hints().hints == whole().hints


@pytest.mark.parametrize("fault", [whole(), InputError("nothing")])
def test_it_reaches_another_process_whole(fault: InputError) -> None:
    again = pickle.loads(pickle.dumps(fault))
    assert type(again) is InputError
    assert str(again) == str(fault)
    assert vars(again) == vars(fault)
