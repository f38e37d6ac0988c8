#include "qFaceToBoneMainWindow.h"

#include "qFaceToBoneBoneTools.h"
#include "qFaceToBoneCase.h"
#include "qFaceToBoneCutTools.h"
#include "qFaceToBoneCutsPanel.h"
#include "qFaceToBoneLandmarksPanel.h"
#include "qFaceToBoneMeasuresPanel.h"
#include "qFaceToBoneObjectsPanel.h"
#include "qFaceToBonePlanPanel.h"
#include "qFaceToBonePointTools.h"
#include "qFaceToBoneSculptPanel.h"
#include "qFaceToBoneSliceView.h"
#include "qFaceToBoneStepsPanel.h"
#include "qFaceToBoneThreeDView.h"
#include "qFaceToBoneToolTip.h"
#include "vtkFaceToBoneSculptRepresentation.h"
#include "vtkFaceToBoneSculptWidget.h"

#include <Core/sculpting/sculpting_session.hpp>

#include <QAction>
#include <QCloseEvent>
#include <QComboBox>
#include <QDesktopServices>
#include <QDir>
#include <QDockWidget>
#include <QFileDialog>
#include <QFileInfo>
#include <QLabel>
#include <QMenuBar>
#include <QMessageBox>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QSettings>
#include <QSlider>
#include <QSplitter>
#include <QStackedWidget>
#include <QStandardPaths>
#include <QStatusBar>
#include <QTabWidget>
#include <QTimer>
#include <QToolButton>
#include <QUrl>
#include <QVBoxLayout>

#include <vtkCommand.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>

qFaceToBoneMainWindow::qFaceToBoneMainWindow(QWidget* parent)
    : QMainWindow(parent), m_case(new qFaceToBoneCase(this)),
      m_tool(vtkSmartPointer<vtkFaceToBoneSculptWidget>::New())
{
  setWindowTitle("FaceToBone");
  auto* split = new QSplitter;
  split->addWidget(makeLeft());
  split->addWidget(makeCentre());
  split->setStretchFactor(1, 1);
  split->setSizes({340, 1000});
  split->setChildrenCollapsible(false);
  setCentralWidget(split);
  makeStatusBar();
  makeMenus();
  connectCase();
  connectTool();
  connectBoneTools();
  connectPointTools();
  m_autosave = new QTimer(this);
  m_autosave->start(1000 * QSettings().value("autosaveSeconds", 20).toInt());
  connect(m_autosave, &QTimer::timeout, this,
          [this]
          {
            const auto session = m_case->sculpting();
            if (!session || !session->in_stroke())
              saveAll();
          });
  const QSettings settings;
  resize(1280, 720);
  restoreGeometry(settings.value("geometry").toByteArray());
  loadedAnother();
}

qFaceToBoneMainWindow::~qFaceToBoneMainWindow()
{
  // they speak of the case while they let go of what is held, and it would be gone first
  delete m_cutTools;
  delete m_boneTools;
  delete m_pointTools;
  m_tool->SetInteractor(nullptr);
}

QWidget* qFaceToBoneMainWindow::makeLeft()
{
  auto* left = new QWidget;
  left->setMinimumWidth(330);
  left->setMaximumWidth(420);
  auto* parts = new QVBoxLayout(left);
  parts->setContentsMargins(4, 4, 0, 4);
  m_steps = new qFaceToBoneStepsPanel(m_case);
  parts->addWidget(m_steps);
  m_pages = new QStackedWidget;
  auto page = [this](QWidget* content)
  {
    auto* area = new QScrollArea;
    area->setWidgetResizable(true);
    area->setFrameShape(QFrame::NoFrame);
    area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    area->setWidget(content);
    m_pages->addWidget(area);
  };
  auto text = [](const QString& words)
  {
    auto* label = new QLabel(words);
    label->setWordWrap(true);
    label->setAlignment(Qt::AlignTop);
    label->setMargin(6);
    return label;
  };
  page(
      text(tr("Open a CT (DICOM folder, .nrrd, .mha, .nii), a case, or the sample from the File "
              "menu. A case names the CT and its landmarks; with a CT alone you place them in step "
              "2, or load them there.")));
  page(makeSurfacesPage());
  m_cutsPanel = new qFaceToBoneCutsPanel(m_case);
  page(m_cutsPanel);
  m_sculptPanel = new qFaceToBoneSculptPanel(m_case);
  page(m_sculptPanel);
  m_planPanel = new qFaceToBonePlanPanel(m_case);
  page(m_planPanel);
  page(text(tr("The report is one file, report.html in the case folder, with pictures and all "
               "figures. Research software, not a medical device.")));
  auto* tabs = new QTabWidget;
  tabs->addTab(m_pages, tr("Step"));
  tabs->addTab(new qFaceToBoneObjectsPanel(m_case->objects()), tr("Objects"));
  m_measuresPanel = new qFaceToBoneMeasuresPanel(m_case);
  tabs->addTab(m_measuresPanel, tr("Measures"));
  tabs->setObjectName("tabs");
  parts->addWidget(tabs, 1);
  connect(m_steps, &qFaceToBoneStepsPanel::currentStepChanged, this,
          [this, tabs](int step)
          {
            tabs->setCurrentIndex(0);
            stepChosen(step);
          });
  connect(m_steps, &qFaceToBoneStepsPanel::actionWanted, this,
          [this](int step)
          {
            if (step == qFaceToBoneCase::Ct)
              return menuBar()->findChild<QAction*>("open")->trigger();
            if (!m_case->start(static_cast<qFaceToBoneCase::Step>(step)))
              complain(m_case->error());
          });
  return left;
}

QWidget* qFaceToBoneMainWindow::makeSurfacesPage()
{
  auto* page = new QWidget;
  auto* words = new QLabel(tr("Skin and bone are found by their density in the CT. The skin found "
                              "here stays the same whatever is cut later."));
  words->setWordWrap(true);
  words->setMargin(4);
  m_landmarksPanel = new qFaceToBoneLandmarksPanel(m_case);
  auto* parts = new QVBoxLayout(page);
  parts->setContentsMargins(0, 0, 0, 0);
  parts->addWidget(words);
  parts->addWidget(m_landmarksPanel, 1);
  return page;
}

QWidget* qFaceToBoneMainWindow::makeWelcome()
{
  auto* welcome = new QWidget;
  auto* parts = new QVBoxLayout(welcome);
  parts->setAlignment(Qt::AlignCenter);
  auto* title = new QLabel(
      tr("<h1>FaceToBone</h1><p style='font-size:14px'>Say how the face should look; see how the "
         "bones must move.</p><p style='color:#7a4a00'>Research software, not a medical "
         "device.</p>"));
  title->setAlignment(Qt::AlignCenter);
  auto* sample = new QPushButton(tr("Try it on the sample patient"));
  auto* open = new QPushButton(tr("Open a CT or a case..."));
  for (QPushButton* button : {sample, open})
  {
    button->setMinimumSize(280, 40);
    button->setMaximumWidth(280);
  }
  sample->setObjectName("sample");
  sample->setToolTip(qFaceToBoneToolTip(tr("Makes a virtual patient and opens it"),
                                        tr("About a minute"), tr("synthetic CT")));
  connect(sample, &QPushButton::clicked, this, &qFaceToBoneMainWindow::openSample);
  connect(open, &QPushButton::clicked, this,
          [this] { menuBar()->findChild<QAction*>("open")->trigger(); });
  parts->addWidget(title, 0, Qt::AlignCenter);
  parts->addWidget(sample, 0, Qt::AlignCenter);
  parts->addWidget(open, 0, Qt::AlignCenter);
  return welcome;
}

QWidget* qFaceToBoneMainWindow::makeViewBar()
{
  auto* bar = new QWidget;
  auto* line = new QHBoxLayout(bar);
  line->setContentsMargins(4, 2, 4, 2);
  line->setSpacing(2);
  static const struct
  {
    const char* name;
    qFaceToBoneThreeDView::Preset preset;
  } presets[] = {{"Frontal", qFaceToBoneThreeDView::Frontal},
                 {"Right", qFaceToBoneThreeDView::Right},
                 {"Left", qFaceToBoneThreeDView::Left},
                 {"Three-quarter", qFaceToBoneThreeDView::ThreeQuarter},
                 {"Submental", qFaceToBoneThreeDView::Submental},
                 {"Top", qFaceToBoneThreeDView::Top}};
  int key = 1;
  for (const auto& p : presets)
  {
    auto* button = new QToolButton;
    button->setText(tr(p.name));
    button->setAutoRaise(true);
    button->setShortcut(QKeySequence(Qt::CTRL + Qt::Key_0 + key));
    button->setToolTip(qFaceToBoneToolTip(tr("Looks at the patient from there"),
                                          tr("Ctrl+%1").arg(key++), tr("view preset")));
    const auto preset = p.preset;
    connect(button, &QToolButton::clicked, this, [this, preset] { m_view->setPreset(preset); });
    line->addWidget(button);
  }
  line->addStretch(1);
  auto* compare = new QToolButton;
  compare->setText(tr("Compare"));
  compare->setObjectName("compare");
  compare->setCheckable(true);
  compare->setAutoRaise(true);
  compare->setToolTip(qFaceToBoneToolTip(tr("Before, target and predicted face side by side"),
                                         tr("Turn one, all turn"), tr("linked cameras")));
  connect(compare, &QToolButton::toggled, this,
          [this](bool on)
          {
            m_view->setLayoutOfViews(on ? qFaceToBoneThreeDView::Compare
                                        : qFaceToBoneThreeDView::Single);
            m_view->fit();
          });
  line->addWidget(compare);
  auto* split = new QSlider(Qt::Horizontal);
  split->setObjectName("split");
  split->setRange(0, 100);
  split->setValue(100);
  split->setMinimumWidth(60);
  split->setMaximumWidth(90);
  split->setToolTip(qFaceToBoneToolTip(tr("Target on the left, predicted face on the right"),
                                       tr("50 %"), tr("split view")));
  connect(split, &QSlider::valueChanged, this,
          [this](int percent) { m_view->setSplit(percent / 100.0); });
  line->addWidget(new QLabel(tr("Split")));
  line->addWidget(split);
  auto* colour = new QComboBox;
  colour->setObjectName("colour");
  colour->addItems({tr("Skin colour"), tr("Displacement"), tr("Mask"), tr("Left of the target")});
  colour->setToolTip(qFaceToBoneToolTip(tr("What the target face is coloured by"),
                                        tr("Displacement"), tr("scalar map")));
  connect(colour, QOverload<int>::of(&QComboBox::currentIndexChanged), this,
          &qFaceToBoneMainWindow::colourTarget);
  line->addWidget(colour);
  return bar;
}

QWidget* qFaceToBoneMainWindow::makeCentre()
{
  auto* views = new QSplitter;
  views->setChildrenCollapsible(false);
  auto* main = new QWidget;
  auto* column = new QVBoxLayout(main);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  m_view = new qFaceToBoneThreeDView(m_case->objects());
  m_case->setSeenInWindow(true);
  connect(m_view, &qFaceToBoneThreeDView::drawn, m_case, &qFaceToBoneCase::caseIsSeen);
  column->addWidget(makeViewBar());
  column->addWidget(m_view, 1);
  views->addWidget(main);
  auto* slices = new QSplitter(Qt::Vertical);
  slices->setChildrenCollapsible(false);
  static constexpr qFaceToBoneSliceView::Orientation orientations[] = {
      qFaceToBoneSliceView::Axial, qFaceToBoneSliceView::Coronal, qFaceToBoneSliceView::Sagittal};
  for (int k = 0; k < 3; ++k)
  {
    m_slices[k] = new qFaceToBoneSliceView(orientations[k], m_case->objects());
    slices->addWidget(m_slices[k]);
    connect(m_slices[k], &qFaceToBoneSliceView::crosshairMoved, this,
            [this](const std::array<double, 3>& point)
            {
              for (qFaceToBoneSliceView* slice : m_slices)
                slice->setCrosshair(point);
              m_view->setCrosshair(point.data());
              say(tr("R %1  A %2  S %3 mm")
                      .arg(point[0], 0, 'f', 1)
                      .arg(point[1], 0, 'f', 1)
                      .arg(point[2], 0, 'f', 1));
            });
    connect(m_slices[k], &qFaceToBoneSliceView::windowLevelChanged, this,
            [this](double window, double level)
            {
              for (qFaceToBoneSliceView* slice : m_slices)
                slice->setWindowLevel(window, level);
              say(tr("Window %1 HU, level %2 HU").arg(window, 0, 'f', 0).arg(level, 0, 'f', 0));
            });
  }
  views->addWidget(slices);
  views->setStretchFactor(0, 1);
  views->setSizes({760, 260});
  m_centre = new QStackedWidget;
  m_centre->addWidget(makeWelcome());
  m_centre->addWidget(views);
  return m_centre;
}

void qFaceToBoneMainWindow::makeStatusBar()
{
  m_message = new QLabel;
  m_progress = new QProgressBar;
  m_progress->setRange(0, 1000);
  m_progress->setMaximumWidth(220);
  m_progress->setTextVisible(false);
  m_cancel = new QPushButton(tr("Cancel"));
  m_cancel->setObjectName("cancel");
  statusBar()->addWidget(m_message, 1);
  statusBar()->addPermanentWidget(m_progress);
  statusBar()->addPermanentWidget(m_cancel);
  m_progress->hide();
  m_cancel->hide();
  connect(m_cancel, &QPushButton::clicked, this,
          [this]
          {
            m_case->task()->cancel();
            say(tr("Cancelling..."));
          });
}

void qFaceToBoneMainWindow::makeMenus()
{
  auto add = [this](QMenu* menu, const QString& text, const QKeySequence& key, auto action,
                    const char* name = "")
  {
    QAction* made = menu->addAction(text);
    made->setShortcut(key);
    made->setObjectName(name);
    made->setParent(menuBar());
    connect(made, &QAction::triggered, this, action);
    return made;
  };
  QMenu* file = menuBar()->addMenu(tr("&File"));
  add(
      file, tr("&Open..."), QKeySequence::Open,
      [this]
      {
        const QString path = QFileDialog::getOpenFileName(
            this, tr("Open a CT or a case"), QSettings().value("lastFolder").toString(),
            tr("CTs and cases (*.json *.mrml *.nrrd *.nhdr *.mha *.mhd *.nii *.nii.gz *.dcm);;"
               "All files (*)"));
        if (!path.isEmpty())
          open(path);
      },
      "open");
  add(
      file, tr("Open &DICOM folder..."), QKeySequence("Ctrl+Shift+O"), [this] { openFolder(); },
      "openFolder");
  m_recent = file->addMenu(tr("Open &recent"));
  add(
      file, tr("Sample &patient"), QKeySequence(), [this] { openSample(); }, "sample");
  file->addSeparator();
  add(
      file, tr("&Save"), QKeySequence::Save,
      [this]
      {
        if (saveAll())
          say(tr("Saved in %1").arg(m_case->folder()));
        else
          complain(m_case->error());
      },
      "save");
  add(
      file, tr("S&creenshot..."), QKeySequence("Ctrl+Shift+S"),
      [this]
      {
        const QString path = QFileDialog::getSaveFileName(this, tr("Screenshot"), "view.png",
                                                          tr("Pictures (*.png)"));
        if (!path.isEmpty() && !m_view->savePicture(path))
          complain(tr("%1 cannot be written; choose another folder").arg(path));
      },
      "screenshot");
  file->addSeparator();
  add(
      file, tr("&Quit"), QKeySequence::Quit, [this] { close(); }, "quit");
  QMenu* edit = menuBar()->addMenu(tr("&Edit"));
  add(
      edit, tr("&Undo"), QKeySequence::Undo, [this] { undo(); }, "undo");
  add(
      edit, tr("&Redo"), QKeySequence::Redo, [this] { redo(); }, "redo");
  edit->addSeparator();
  add(
      edit, tr("&Preferences..."), QKeySequence::Preferences, [this] { preferences(); },
      "preferences");
  QMenu* view = menuBar()->addMenu(tr("&View"));
  add(
      view, tr("&Fit"), QKeySequence("F"), [this] { m_view->fit(); }, "fit");
  add(
      view, tr("&Before / after"), QKeySequence("B"),
      [this]
      {
        const qFaceToBoneObject* skin = m_case->objects()->find("skin");
        if (!skin)
          return;
        const bool before = !skin->visible;
        m_case->objects()->setVisible("skin", before);
        m_case->objects()->setVisible("target", !before);
      },
      "beforeAfter");
  QMenu* help = menuBar()->addMenu(tr("&Help"));
  add(
      help, tr("&About"), QKeySequence(), [this] { about(); }, "about");
  updateRecent();
}
