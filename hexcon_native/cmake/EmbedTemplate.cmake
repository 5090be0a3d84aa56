# SPDX-License-Identifier: LGPL-2.1-or-later
# A template file of resources/templates as C arrays: the core reads no files, and the compiler's
# numbers do not depend on a locale.

function(hexcon_embed_template stem output)
  get_filename_component(name ${stem} NAME)
  set(path ${CMAKE_CURRENT_SOURCE_DIR}/../resources/templates/${stem}.txt)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${path})
  set(number "([^ ]+)")
  foreach(kind v h q)
    file(STRINGS ${path} ${kind}_lines REGEX "^${kind} ")
    list(LENGTH ${kind}_lines ${kind}_count)
    list(TRANSFORM ${kind}_lines STRIP)
  endforeach()
  list(TRANSFORM v_lines REPLACE "^v ${number} ${number} ${number} ${number} ${number}$"
                                 "  {{\\2, \\3, \\4}, \"\\5\"},\n")
  list(TRANSFORM h_lines REPLACE "^h (.*)$" "  {\\1},\n")
  list(TRANSFORM q_lines REPLACE "^q (.*)$" "  {\\1},\n")
  list(JOIN v_lines "" points)
  foreach(kind h q)
    list(TRANSFORM ${kind}_lines REPLACE "([0-9]) ([0-9])" "\\1, \\2" OUTPUT_VARIABLE ${kind}_once)
    list(TRANSFORM ${kind}_once REPLACE "([0-9]) ([0-9])" "\\1, \\2" OUTPUT_VARIABLE ${kind}_twice)
    list(JOIN ${kind}_twice "" ${kind}_rows)
  endforeach()
  file(WRITE ${output}.new
    "/* Made from resources/templates/${stem}.txt */\n"
    "#include \"construct/hex_template.h\"\n\n"
    "static const template_point points[] = {\n${points}};\n\n"
    "static const int32_t hexes[][8] = {\n${h_rows}};\n\n"
    "static const int32_t quads[][4] = {\n${q_rows}};\n\n"
    "const hex_template template_${name} = {\"${name}\", ${v_count}, ${h_count}, ${q_count}, points,"
    " hexes, quads};\n")
  file(COPY_FILE ${output}.new ${output} ONLY_IF_DIFFERENT)
endfunction()
