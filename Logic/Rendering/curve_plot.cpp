#include <Rendering/curve_plot.hpp>

#include <Core/error.hpp>
#include <Rendering/quiet_messages.hpp>

#include <vtkAxis.h>
#include <vtkBrush.h>
#include <vtkChartLegend.h>
#include <vtkChartXY.h>
#include <vtkContextActor.h>
#include <vtkContextScene.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPen.h>
#include <vtkPlotPoints.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkStringArray.h>
#include <vtkTable.h>
#include <vtkTextProperty.h>
#include <vtkWindowToImageFilter.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace f2b
{
namespace
{

// letters as a share of the picture's height, so that a printed column stays readable
constexpr double letter_share = 1.0 / 36;

vtkSmartPointer<vtkTable> table_of(const PlottedSeries& series)
{
  auto table = vtkSmartPointer<vtkTable>::New();
  for (const auto& [name, values] :
       {std::pair{std::string("x"), &series.x}, {series.label, &series.y}})
  {
    vtkNew<vtkDoubleArray> column;
    column->SetName(name.c_str());
    for (const double value : *values)
      column->InsertNextValue(value);
    table->AddColumn(column);
  }
  return table;
}

void add_series(vtkChartXY* chart, const PlottedSeries& series, double pen_width)
{
  const bool points = series.style == PlottedSeries::Style::Points;
  vtkPlot* plot = chart->AddPlot(points ? vtkChart::POINTS : vtkChart::LINE);
  const auto table = table_of(series);
  plot->SetInputData(table, 0, 1);
  plot->SetLabel(series.label);
  plot->GetPen()->SetColorF(series.colour[0], series.colour[1], series.colour[2]);
  plot->SetWidth(static_cast<float>(pen_width));
  if (series.style == PlottedSeries::Style::DashedLine)
    plot->GetPen()->SetLineType(vtkPen::DASH_LINE);
  if (auto* marks = vtkPlotPoints::SafeDownCast(plot); marks && points)
  {
    marks->SetMarkerStyle(vtkPlotPoints::CIRCLE);
    marks->SetMarkerSize(static_cast<float>(4 * pen_width));
  }
}

/// The span of one coordinate over all series, widened a little.
std::array<double, 2> span(const CurvePlot& plot, std::vector<double> PlottedSeries::*coordinate)
{
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const PlottedSeries& series : plot.series)
    for (const double value : series.*coordinate)
    {
      low = std::min(low, value);
      high = std::max(high, value);
    }
  const double margin = high > low ? 0.04 * (high - low) : 1;
  return {low - margin, high + margin};
}

/// The largest of 1, 2 and 5 times a power of ten that divides a span into at least five.
double tick_step(double length)
{
  const double decade = std::pow(10, std::floor(std::log10(length / 5)));
  const double share = length / 5 / decade;
  return decade * (share >= 5 ? 5 : share >= 2 ? 2 : 1);
}

/// Ticks at round values, all with as many decimals as the step needs.
void set_ticks(vtkAxis* axis, const std::array<double, 2>& range)
{
  const double step = tick_step(range[1] - range[0]);
  const int decimals = std::max(0, -static_cast<int>(std::floor(std::log10(step) + 1e-9)));
  vtkNew<vtkDoubleArray> positions;
  vtkNew<vtkStringArray> labels;
  for (double i = std::ceil(range[0] / step); i * step <= range[1]; ++i)
  {
    char label[40];
    std::snprintf(label, sizeof label, "%.*f", decimals, i * step + 0.0);
    positions->InsertNextValue(i * step);
    labels->InsertNextValue(label);
  }
  axis->SetCustomTickPositions(positions, labels);
}

void set_axis(vtkAxis* axis, const std::string& title, const std::array<double, 2>& range,
              int letter)
{
  axis->SetTitle(title);
  axis->SetBehavior(vtkAxis::FIXED);
  axis->SetRange(range[0], range[1]);
  set_ticks(axis, range);
  axis->GetTitleProperties()->SetFontSize(letter);
  axis->GetTitleProperties()->BoldOff();
  axis->GetLabelProperties()->SetFontSize(letter);
  axis->GetGridPen()->SetColorF(0.88, 0.88, 0.88);
}

vtkSmartPointer<vtkChartXY> chart_of(const CurvePlot& plot, int letter)
{
  auto chart = vtkSmartPointer<vtkChartXY>::New();
  chart->SetTitle(plot.title);
  chart->GetTitleProperties()->SetFontSize(letter + letter / 6);
  for (const PlottedSeries& series : plot.series)
    add_series(chart, series, letter / 9.0);
  set_axis(chart->GetAxis(vtkAxis::BOTTOM), plot.x_title, span(plot, &PlottedSeries::x), letter);
  set_axis(chart->GetAxis(vtkAxis::LEFT), plot.y_title, span(plot, &PlottedSeries::y), letter);
  chart->SetShowLegend(true);
  vtkChartLegend* legend = chart->GetLegend();
  legend->SetLabelSize(letter);
  legend->SetSymbolWidth(2 * letter);
  legend->SetPadding(letter / 2);
  legend->SetHorizontalAlignment(vtkChartLegend::LEFT); // curves of tissue rise to the right
  legend->SetVerticalAlignment(vtkChartLegend::TOP);
  return chart;
}

} // namespace

Image draw_plot(const CurvePlot& plot, PixelSize size)
{
  const QuietMessages messages;
  vtkNew<vtkContextActor> actor;
  actor->GetScene()->AddItem(chart_of(plot, static_cast<int>(letter_share * size.height)));
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(1, 1, 1);
  renderer->AddActor(actor);
  actor->GetScene()->SetRenderer(renderer);
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetShowWindow(false);
  window->SetMultiSamples(8);
  window->SetSize(size.width, size.height);
  window->AddRenderer(renderer);
  window->Render();
  vtkNew<vtkWindowToImageFilter> grab;
  grab->SetInput(window);
  grab->SetInputBufferTypeToRGB();
  grab->ReadFrontBufferOff();
  grab->ShouldRerenderOff();
  grab->Update();
  Image image = grab->GetOutput();
  const int* dimensions = image->GetDimensions();
  if (dimensions[0] != size.width || dimensions[1] != size.height)
    throw Error("plot", "VTK could not draw it. " + messages.first_error(),
                "check the OpenGL driver, or unset DISPLAY to draw in software");
  return image;
}

} // namespace f2b
