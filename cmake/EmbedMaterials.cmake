# Builds the files of materials/ into verdigris_io, and installs them for those who want to change them.
file(GLOB VERDIGRIS_MATERIAL_FILES CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/materials/*.toml)
list(SORT VERDIGRIS_MATERIAL_FILES)
set(VERDIGRIS_MATERIAL_ENTRIES "")
foreach(file ${VERDIGRIS_MATERIAL_FILES})
  set_property(DIRECTORY ${PROJECT_SOURCE_DIR} APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
  get_filename_component(name ${file} NAME_WE)
  file(READ ${file} text)
  string(APPEND VERDIGRIS_MATERIAL_ENTRIES "    {\"${name}\", R\"toml(${text})toml\"},\n")
endforeach()
set(VERDIGRIS_MATERIAL_DIR ${CMAKE_INSTALL_FULL_DATADIR}/verdigris/materials)
configure_file(${CMAKE_CURRENT_LIST_DIR}/embedded_materials.cpp.in
  ${PROJECT_BINARY_DIR}/generated/embedded_materials.cpp @ONLY)

target_sources(verdigris_io PRIVATE ${PROJECT_BINARY_DIR}/generated/embedded_materials.cpp)
target_include_directories(verdigris_io PRIVATE ${PROJECT_SOURCE_DIR}/src/io)
install(FILES ${VERDIGRIS_MATERIAL_FILES} DESTINATION ${CMAKE_INSTALL_DATADIR}/verdigris/materials)
