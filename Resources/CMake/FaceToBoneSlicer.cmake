# In 3D Slicer: what its extension index asks for, and its macros. Included at the top level, after project().

set(EXTENSION_HOMEPAGE "NA")
set(EXTENSION_CATEGORY "Surgery planning")
set(EXTENSION_CONTRIBUTORS "The FaceToBone maintainers")
set(EXTENSION_DESCRIPTION "Plans cranio-maxillofacial surgery from the face backwards: from the face that a patient should have to the movement of the cut bone, and the face that this movement gives. Research software, not a medical device.")
set(EXTENSION_ICONURL "NA")
set(EXTENSION_SCREENSHOTURLS "NA")
set(EXTENSION_DEPENDS "NA")
set(EXTENSION_STATUS "Beta")
set(EXTENSION_LICENSE_FILE "${CMAKE_CURRENT_SOURCE_DIR}/LICENSE")
set(EXTENSION_README_FILE "${CMAKE_CURRENT_SOURCE_DIR}/README.md")

find_package(Slicer REQUIRED)
include(${Slicer_USE_FILE})

set(FACETOBONE_IN_SLICER ON)
