#pragma once

#define VTK_MRML_LOGIC_EXPORT
