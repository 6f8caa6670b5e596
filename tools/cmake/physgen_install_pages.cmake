# Installation of pages of documentation, whose links then lead to what is installed.

# physgen_install_pages(PAGES page.md... PICTURES picture.svg... PLACES folder destination folder destination...)
# Installs pages and pictures below the folder of documentation, under the paths that they have in the project. A link of
# a page to one of them, or to what lies below a folder of PLACES, leads to where that is installed; of a link to anything
# else of the project only the text stays. Paths are relative to the project, destinations as install() takes them.
function(physgen_install_pages)
  cmake_parse_arguments(PARSE_ARGV 0 arg "" "" "PAGES;PICTURES;PLACES")
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${arg_PAGES})
  set(places)
  foreach(file IN LISTS arg_PAGES arg_PICTURES)  # first, since they may lie below a folder of PLACES
    list(APPEND places ${file} ${CMAKE_INSTALL_DOCDIR}/${file})
  endforeach()
  list(APPEND places ${arg_PLACES})

  foreach(page IN LISTS arg_PAGES)
    cmake_path(GET page PARENT_PATH folder)
    file(READ ${PROJECT_SOURCE_DIR}/${page} text)
    string(REGEX MATCHALL "\\([A-Za-z0-9_./-]+(#[a-z0-9_-]+)?\\)" links "${text}")
    list(REMOVE_DUPLICATES links)
    foreach(link IN LISTS links)
      string(REGEX REPLACE "[()]|#.*" "" target "${link}")
      string(REGEX MATCH "#[^)]+" heading "${link}")
      cmake_path(ABSOLUTE_PATH target BASE_DIRECTORY ${PROJECT_SOURCE_DIR}/${folder} NORMALIZE)
      if(EXISTS ${target})  # else it is an argument of a function, in an example
        cmake_path(RELATIVE_PATH target BASE_DIRECTORY ${PROJECT_SOURCE_DIR})
        physgen_installed_as(installed ${target} ${places})
        if(installed)
          cmake_path(RELATIVE_PATH installed BASE_DIRECTORY ${CMAKE_INSTALL_FULL_DOCDIR}/${folder})
          string(REPLACE "]${link}" "](${installed}${heading})" text "${text}")
        else()
          string(REGEX REPLACE "[().]" "\\\\\\0" link "${link}")
          string(REGEX REPLACE "\\[([^][]+)\\]${link}" "\\1" text "${text}")
        endif()
      endif()
    endforeach()
    file(WRITE ${PROJECT_BINARY_DIR}/package/${page} "${text}")
    install(FILES ${PROJECT_BINARY_DIR}/package/${page} DESTINATION ${CMAKE_INSTALL_DOCDIR}/${folder})
  endforeach()
  foreach(picture IN LISTS arg_PICTURES)
    cmake_path(GET picture PARENT_PATH folder)
    install(FILES ${picture} DESTINATION ${CMAKE_INSTALL_DOCDIR}/${folder})
  endforeach()
endfunction()

# physgen_installed_as(result path [folder destination]...): the full path under which something of the project is
# installed, by the first folder that is or holds it; empty where none does.
function(physgen_installed_as result path)
  set(places ${ARGN})
  while(places)
    list(POP_FRONT places folder destination)
    cmake_path(IS_PREFIX folder "${path}" NORMALIZE is_below)
    if(is_below)
      cmake_path(RELATIVE_PATH path BASE_DIRECTORY "${folder}")  # "." where it is the folder, or a file by itself
      cmake_path(ABSOLUTE_PATH destination BASE_DIRECTORY "${CMAKE_INSTALL_PREFIX}")
      cmake_path(SET destination NORMALIZE "${destination}/${path}")
      string(REGEX REPLACE "/$" "" destination "${destination}")
      set(${result} "${destination}" PARENT_SCOPE)
      return()
    endif()
  endwhile()
  set(${result} "" PARENT_SCOPE)
endfunction()
