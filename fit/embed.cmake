# Makes a file a part of the program, which then needs no file beside it: the bytes stand between the symbols
# NAME and NAME_end. Sets NAME_source to the source that holds them.
function(trunk_embed name file)
  set(source ${CMAKE_CURRENT_BINARY_DIR}/embedded/${name}.cpp)
  file(CONFIGURE OUTPUT ${source} @ONLY CONTENT [=[
asm(R"(
.section .rodata
.global @name@, @name@_end
@name@: .incbin "@file@"
@name@_end:
.text
)");
]=])
  set_source_files_properties(${source} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON OBJECT_DEPENDS ${file})
  set(${name}_source ${source} PARENT_SCOPE)
endfunction()

# The pages that `trunk help TOPIC` prints: topic, page, what the page tells.
set(TRUNK_TOPICS
  "start|README.md|what trunk is for, its limits, and a first session"
  "fitting|fit/README.md|traces, breaths, the fit and its verdict"
  "pressures|fit/channels/README.md|pressures beside volume, numbers of a clinic"
  "sweeps|fit/sweep/README.md|many breaths, many subjects, sweeps and clusters"
  "structure|fit/structure/README.md|what choices of the model are worth"
  "scenarios|scenarios/README.md|the shipped ones, keys, loads, a trunk of your own"
  "model|libtrunk/README.md|the equations, the map of the code, the libraries"
  "results|libtrunk/io/README.md|result files, and readers in Python and MATLAB"
  "registration|libtrunk/registration/README.md|measured surfaces and your subject's geometry"
  "evidence|reference/README.md|what the results are compared with"
  "tests|tests/README.md|kinds of tests, how to add one, speed"
  "scripts|scripts/README.md|a line about every script"
  "contributing|.github/CONTRIBUTING.md|conventions, and how to add something")

# Sets TRUNK_TOPIC_SOURCES to the sources of all pages and of the table of topics.
function(trunk_embed_topics)
  set(sources ${CMAKE_CURRENT_BINARY_DIR}/embedded/topics.cpp)
  foreach(row ${TRUNK_TOPICS})
    string(REGEX MATCH "^(.+)[|](.+)[|](.+)$" matched "${row}")
    set(name trunk_page_${CMAKE_MATCH_1})
    string(APPEND symbols "extern \"C\" const char ${name}[], ${name}_end[];\n")
    string(APPEND rows "      {\"${CMAKE_MATCH_1}\", \"${CMAKE_MATCH_3}\", text_between(${name}, ${name}_end)},\n")
    trunk_embed(${name} ${PROJECT_SOURCE_DIR}/${CMAKE_MATCH_2})
    list(APPEND sources ${${name}_source})
  endforeach()
  configure_file(commands/help/topics.cpp.in ${CMAKE_CURRENT_BINARY_DIR}/embedded/topics.cpp @ONLY)
  set(TRUNK_TOPIC_SOURCES ${sources} PARENT_SCOPE)
endfunction()
