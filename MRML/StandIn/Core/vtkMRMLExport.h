#pragma once

#define VTK_MRML_EXPORT
