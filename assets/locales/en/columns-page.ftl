# The columns of a file of measurements: seen, corrected and remembered.

columns-page-import = Columns…
columns-page-hint = Shows how each column of a file is read before its values are imported
columns-page-take = Import
columns-page-correct = Columns…
columns-page-forget = Forget these columns
columns-page-dialog = Import and choose columns
columns-page-title = Columns of { $name }
columns-page-wanted = Choose what each column holds. Files with the same layout will be read the same way.
columns-page-uncertain = Some columns are uncertain: check what each one holds, then import. Files with the same layout will be read the same way.
columns-page-sheet = Sheet
columns-page-separator = Separator
columns-page-separator-semicolon = Semicolon
columns-page-separator-comma = Comma
columns-page-separator-tab = Tab
columns-page-separator-pipe = Vertical bar
columns-page-decimal = Decimal sign
columns-page-decimal-point = Point
columns-page-decimal-comma = Comma
columns-page-as-found = As in the file
columns-page-unit = Unit of sizes
columns-page-place-unit = Unit of X, Y, Z
columns-page-unit-names = From the header, else mm
columns-page-unit-from = From the file: { $from }
columns-page-unit-mm = mm
columns-page-unit-um = µm
columns-page-unit-inch = inch
columns-page-first-row = First row
columns-page-below-header = Below the header
columns-page-line = Line { $line }
columns-page-column = { $number } { $name }
columns-page-role-none = not used
columns-page-role-name = name
columns-page-role-number = number
columns-page-role-callout = callout
columns-page-role-nominal = nominal size
columns-page-role-measured = measured value
columns-page-role-time = time
columns-page-role-simulated = simulated
columns-page-role-part = part
columns-page-role-serial = serial number
columns-page-role-who = operator
columns-page-role-x = X
columns-page-role-y = Y
columns-page-role-z = Z
columns-page-role-quantity = what was measured
columns-page-header = { $line } header
columns-page-row = { $line }
columns-page-not-read = { $line } not read
columns-page-read = { $rows ->
        [0] None of the rows shown is read
        [one] { $read } of 1 row shown becomes a value
       *[other] { $read } of { $rows } rows shown become values
    }
columns-page-first-problem = First problem: { $why }
columns-page-no-measured = No column holds the measured value: choose one
columns-page-no-callout = No column holds the callout, so no value can be judged: choose one
columns-page-no-name = No column identifies the feature of a value: choose name, number, or X and Y
columns-page-taken = Columns: { $columns }; unit of sizes: { $unit }
columns-page-taken-one = { $column } → { $role }
columns-page-remembered = Columns read as corrected on { $day }
columns-page-forgotten = Columns forgotten: the next file with this layout is read as if it were the first one. The values of this file are kept.
columns-page-none = { $name } is not a table with columns
columns-page-large = { $name } is too large to read with corrected columns in the window: use fitcheck import --columns
