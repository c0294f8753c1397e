"""Where the rows of a sweep are kept: in memory, or in a folder of Parquet files, one for each batch."""

from __future__ import annotations

import uuid
from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING

from pairtrawl.errors import InputError
from pairtrawl.sweeping.rows import Row

if TYPE_CHECKING:
    import pandas as pd
    import pyarrow as pa


class Store:
    """Rows by their keys. With a folder, those of earlier sweeps are there already."""

    def __init__(self, schema: pa.Schema, folder: str | PathLike[str] | None) -> None:
        self._schema = schema
        self._folder = None if folder is None else Path(folder)
        self._tables: list[pa.Table] = []
        self.keys: set[str] = set()
        if self._folder is not None:
            self._folder.mkdir(parents=True, exist_ok=True)
            self.keys.update(key for part in self._parts() for key in _read(part, ["key"])["key"].to_pylist())

    def _parts(self) -> list[Path]:
        return [] if self._folder is None else sorted(self._folder.glob("part-*.parquet"))

    def add(self, rows: list[Row]) -> None:
        """Keeps the rows of a batch. A file is there whole or not at all."""
        import pyarrow as pa
        import pyarrow.parquet as pq

        texts = [name for name, kind in zip(self._schema.names, self._schema.types) if kind == pa.string()]
        for row in rows:
            # An option whose values are of several kinds is told in words.
            row.update({name: str(row[name]) for name in texts if row.get(name) is not None})
        table = pa.Table.from_pylist(rows, schema=self._schema)
        self.keys.update(table["key"].to_pylist())
        if self._folder is None:
            self._tables.append(table)
            return
        name = f"part-{uuid.uuid4().hex}.parquet"
        unfinished = self._folder / f".{name}.unfinished"
        pq.write_table(table, unfinished)
        unfinished.replace(self._folder / name)

    def frame(self, keys: list[str]) -> pd.DataFrame:
        """The rows of these keys, in this order."""
        import pyarrow as pa

        tables = self._tables + [_read(part, None) for part in self._parts()]
        tables = [table.select([name for name in self._schema.names if name in table.column_names]) for table in tables]
        if not tables:
            tables = [self._schema.empty_table()]
        # A folder may hold rows of sweeps over other options: what they do not have is empty.
        whole = pa.concat_tables([self._schema.empty_table(), *tables], promote_options="permissive")
        frame: pd.DataFrame = whole.select(self._schema.names).to_pandas()
        return frame.drop_duplicates("key").set_index("key").loc[keys].reset_index(drop=True)


def _read(part: Path, columns: list[str] | None) -> pa.Table:
    import pyarrow as pa
    import pyarrow.parquet as pq

    try:
        return pq.read_table(part, columns=columns)
    except (pa.ArrowException, OSError, KeyError) as error:
        raise InputError(
            f"{part} is no part of a sweep: {error}", help="remove the file: its rows are then planned again"
        ) from error
