#include <Rendering/report_style.hpp>

namespace f2b
{

const char* const report_style = R"css(
* { box-sizing: border-box; }
html { font: 16px/1.5 "Helvetica Neue", Arial, "Liberation Sans", "DejaVu Sans", sans-serif; }
body { max-width: 66rem; margin: 0 auto; padding: 2rem 1.5rem 4rem; color: #1c2127;
  background: #fff; overflow-wrap: break-word; }
header { border-bottom: 3px solid #0b4f7d; padding-bottom: .8rem; margin-bottom: 1.2rem; }
h1 { font-size: 1.9rem; line-height: 1.2; margin: 0; }
.case { font-size: 1.15rem; color: #4d5660; margin: .2rem 0 0; }
h2 { font-size: 1.3rem; margin: 2.4rem 0 .6rem; color: #0b4f7d; break-after: avoid; }
p { margin: .4rem 0; max-width: 46rem; }
h2 + p { break-after: avoid; }
.note { color: #4d5660; font-size: .9rem; break-inside: avoid; break-before: avoid; }
.device { border: 2px solid #9a3412; background: #fff7ed; padding: .6rem .9rem; margin: 1rem 0;
  max-width: none; }
.box { border-left: 4px solid #0b4f7d; background: #f3f5f7; padding: .6rem 1rem; }
.warning { border-left: 4px solid #b45309; background: #fffbeb; padding: .6rem 1rem; }
.box, .warning { break-inside: avoid; margin-top: 1.6rem; }
.box h2, .warning h2 { margin-top: .2rem; font-size: 1.1rem; }
.box ul, .warning ul { margin: .3rem 0; padding-left: 1.2rem; }
.scroll { overflow-x: auto; }
table { border-collapse: collapse; margin: .6rem 0 1rem; width: 100%;
  font-variant-numeric: tabular-nums; }
.short { break-inside: avoid; }
.code td { font: .85rem/1.5 "DejaVu Sans Mono", "Liberation Mono", Menlo, Consolas, monospace; }
tr { break-inside: avoid; }
caption, thead { break-after: avoid; }
tbody tr:first-child { break-before: avoid; break-after: avoid; }
thead { display: table-header-group; }
caption { caption-side: top; text-align: left; color: #1c2127; font-weight: 600;
  padding-bottom: .3rem; }
th, td { text-align: left; vertical-align: top; padding: .3rem .6rem;
  border-bottom: 1px solid #cfd5db; }
thead th { border-bottom: 2px solid #1c2127; background: #f3f5f7; font-size: .92rem;
  vertical-align: bottom; }
tbody th { font-weight: 600; white-space: nowrap; }
.facts tbody th { width: 34%; font-weight: 400; color: #4d5660; white-space: normal; }
.facts td, .code td { overflow-wrap: anywhere; }
td.number, th.number { text-align: right; }
figure { margin: 1.2rem 0 1.8rem; break-inside: avoid; }
figure img { display: block; width: 100%; height: auto; border: 1px solid #cfd5db; }
figcaption { margin-top: .4rem; font-size: .92rem; color: #4d5660; }
figcaption strong { color: #1c2127; }
footer { margin-top: 3rem; border-top: 1px solid #cfd5db; padding-top: .6rem;
  color: #4d5660; font-size: .9rem; }
.viewer { border: 1px solid #cfd5db; margin: .6rem 0 1.2rem; }
.viewer canvas { display: block; width: 100%; height: 34rem; background: #eef1f4; cursor: grab;
  touch-action: none; }
.viewer canvas:focus-visible, .viewer input:focus-visible, .viewer button:focus-visible,
.viewer select:focus-visible, .scroll:focus-visible { outline: 3px solid #0b4f7d;
  outline-offset: 1px; }
.controls { display: flex; flex-wrap: wrap; gap: .5rem 1.4rem; padding: .7rem .9rem;
  background: #f3f5f7; align-items: center; }
.controls label { display: inline-flex; align-items: center; gap: .4rem; }
.controls .slide { flex: 1 1 100%; }
.controls input[type=range] { flex: 1; min-width: 8rem; }
.controls button, .controls select { font: inherit; padding: .15rem .6rem; }
.viewer .scale { display: flex; align-items: center; gap: .6rem; padding: .4rem .9rem;
  font-size: .9rem; }
.viewer .scale i { flex: 0 0 16rem; height: 1rem; border: 1px solid #1c2127; }
.viewer .keys { padding: .2rem .9rem .6rem; margin: 0; max-width: none; }
[hidden] { display: none !important; }
@page { margin: 16mm 15mm 18mm;
  @bottom-right { content: counter(page) " / " counter(pages); font: 9pt "DejaVu Sans", sans-serif;
    color: #4d5660; } }
@media print {
  html { font-size: 9.5pt; }
  body { max-width: none; padding: 0; }
  .viewer { display: none; }
  .scroll { overflow: visible; }
  .screen { display: none; }
  th, td { padding: .22rem .4rem; }
  .wide th, .wide td { padding: .22rem .25rem; font-size: .88rem; }
  .code td { font-size: .84rem; }
  .code tbody th { width: 20%; }
  * { -webkit-print-color-adjust: exact; print-color-adjust: exact; }
}
)css";

} // namespace f2b
