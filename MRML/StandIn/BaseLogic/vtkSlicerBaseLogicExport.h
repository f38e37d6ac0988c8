#pragma once

#define VTK_SLICER_BASE_LOGIC_EXPORT
