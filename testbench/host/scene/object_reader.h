#pragma once

#include "testbench/host/scene/scene.h"
#include "testbench/host/scene/table_reader.h"

namespace repousse::host {

/// Reads one [[object]] of a scene; `index` counts from 0 and names an object without a name.
Object read_object(const TomlValue& table, int index, ReadContext& context);

/// Reads the recipe keys of a map table: kind and its parameters, or nothing when `file` is given.
/// Also reads fallback tables, where a file is not allowed.
MapRecipe read_recipe(TableReader& reader, MapKind fallback_kind);

/// Reads [object.map].
MapSource read_map_source(const TomlValue& table, ReadContext& context);

/// Reads `method` and the table of its settings; refuses the tables of other methods, and methods
/// and tables that are reserved. Which tables an object must have depends on its method.
void read_method(TableReader& reader, Object& object, ReadContext& context);

}  // namespace repousse::host
