# SPDX-License-Identifier: LGPL-2.1-or-later
# A table of resources/fillings as a C array of texts: the core reads no files.

function(hexcon_embed_fillings name output)
  set(path ${CMAKE_CURRENT_SOURCE_DIR}/../resources/fillings/${name}.txt)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${path})
  set(word "([^ \n]+)")
  file(READ ${path} lines)
  string(REGEX REPLACE "#[^\n]*\n" "" lines "${lines}")
  string(REGEX REPLACE "${word} ${word} ${word} ${word}\n" "  {\"\\1\", \\2,\n   \"\\3\",\n   \"\\4\"},\n"
         records "${lines}")
  file(WRITE ${output}.new
    "/* Made from resources/fillings/${name}.txt */\n"
    "#include \"construct/small_fillings.h\"\n\n"
    "static const small_filling_record records[] = {\n${records}};\n\n"
    "const small_filling_table small_fillings_${name} = {sizeof records / sizeof *records, records};\n")
  file(COPY_FILE ${output}.new ${output} ONLY_IF_DIFFERENT)
endfunction()
