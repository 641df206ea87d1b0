"""Stationary films on the fine grids of tests/reference/table3.json; environment as for cli_test.py."""
import unittest

from films import BARBIERI, CIRCULAR, REFERENCE, WANG, FilmTest


class FineGrids(FilmTest):
    def test_fine_rows_of_table_3(self):
        for row in REFERENCE["steady_pitch"][1:]:
            for processes in (1, 2):
                with self.subTest(nx=row["nx"], ny=row["ny"], processes=processes):
                    self.assert_row(BARBIERI, row, processes=processes)

    def test_fine_circular_contact(self):
        for row in REFERENCE["steady_circular_M20_L10"][1:]:
            self.assert_row(CIRCULAR, row, processes=2, load=5.746)

    def test_fine_wang_pair(self):
        for row in REFERENCE["table2_pitch"][1:]:
            self.assert_row(WANG, row, processes=2)


if __name__ == "__main__":
    unittest.main()
