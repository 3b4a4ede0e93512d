-- | All specifications: the one list of them. Their modules are called by what they show, which
-- hspec-discover would not find.
module Main (main) where

import System.IO (BufferMode (LineBuffering), hSetBuffering, stdout)
import System.Posix.Signals (Handler (Ignore), installHandler, sigPIPE)
import qualified Test.App.AssembliesDrawn
import qualified Test.App.RecognitionsDrawn
import qualified Test.Code.Array.AdviceByVisiting
import qualified Test.Code.Array.CellsOfTheFold
import qualified Test.Code.Array.FoldingsByWalking
import qualified Test.Code.Array.SharedWindows
import qualified Test.Code.Census.AllArraysOfASize
import qualified Test.Code.Certificate.EachFlawFound
import qualified Test.Code.Certificate.ForgeriesRefused
import qualified Test.Code.Certificate.IssuedAndChecked
import qualified Test.Code.Factorisation.FactorsAndPrimes
import qualified Test.Code.Field.ExtensionModuloH
import qualified Test.Code.Field.FactsFromElsewhere
import qualified Test.Code.Field.StructureByDefinition
import qualified Test.Code.Field.TablesAndElements
import qualified Test.Code.LinearCode.AllCodewords
import qualified Test.Code.Locate.ByInformationSets
import qualified Test.Code.Locate.ChanceByEnumeration
import qualified Test.Code.Locate.EveryDecoderAsDefined
import qualified Test.Code.Locate.FarBelowDoubles
import qualified Test.Code.Locate.ForeignMixture
import qualified Test.Code.Locate.ForeignPatches
import qualified Test.Code.Locate.MemoryTable
import qualified Test.Code.Locate.ParityChecks
import qualified Test.Code.Locate.ProbabilitiesByBayes
import qualified Test.Code.Locate.SeveralPatches
import qualified Test.Code.Locate.UnknownOrientation
import qualified Test.Code.Locate.WhichDecoder
import qualified Test.Code.Polynomial.OrderAndCount
import qualified Test.Code.Polynomial.RingAndOrders
import qualified Test.Code.Profile.DoorToArrays
import qualified Test.Code.Sequence.FactsFromElsewhere
import qualified Test.Code.Sequence.FastFormsAsDefined
import qualified Test.Code.Sequence.ShiftRegisters
import qualified Test.Code.Window.DistanceByPairs
import qualified Test.Code.Window.MasksAndPacking
import qualified Test.Code.Window.ProvedExhaustively
import qualified Test.Code.Window.ProvedTwice
import qualified Test.CommandLine
import qualified Test.CommandLine.Advice
import qualified Test.CommandLine.Bounds
import qualified Test.CommandLine.Census
import qualified Test.CommandLine.Chance
import qualified Test.CommandLine.Decode
import qualified Test.CommandLine.Emboss
import qualified Test.CommandLine.Fields
import qualified Test.CommandLine.Images
import qualified Test.CommandLine.Json
import qualified Test.CommandLine.Locate
import qualified Test.CommandLine.LongWork
import qualified Test.CommandLine.Nets
import qualified Test.CommandLine.Networks
import qualified Test.CommandLine.Output
import qualified Test.CommandLine.Patches
import qualified Test.CommandLine.Picture
import qualified Test.CommandLine.Place
import qualified Test.CommandLine.Pose
import qualified Test.CommandLine.Proof
import qualified Test.CommandLine.Rates
import qualified Test.CommandLine.Sensor
import qualified Test.CommandLine.Sequences
import qualified Test.CommandLine.Shapes
import qualified Test.CommandLine.Shards
import qualified Test.CommandLine.Smallest
import qualified Test.CommandLine.SolidsInWords
import qualified Test.Common.DecimalsByDefinition
import qualified Test.Common.PlainTexts
import qualified Test.Common.SymmetryGroup
import qualified Test.Conformance.Definition
import qualified Test.Conformance.InProcess
import qualified Test.Conformance.Laws
import qualified Test.Conformance.Operations
import qualified Test.Conformance.Process.Checks
import qualified Test.Conformance.Process.Faults
import qualified Test.Conformance.Process.Output
import qualified Test.Conformance.Properties
import qualified Test.Conformance.Report
import qualified Test.Conformance.Run.Choice
import qualified Test.Conformance.Run.Counterexamples
import qualified Test.Conformance.Run.Search
import qualified Test.Conformance.Run.Whole
import qualified Test.Conformance.Serve
import qualified Test.Conformance.Vectors
import qualified Test.Conformance.Versions
import qualified Test.Conformance.Wire.Lines
import qualified Test.Documents
import Test.Effort (byEffort)
import qualified Test.Examples
import qualified Test.Formats
import qualified Test.Formats.CensusFile
import qualified Test.Formats.EvaluationFile
import qualified Test.Formats.Json
import qualified Test.Formats.Networks
import qualified Test.Formats.Rates
import qualified Test.Formats.Registration
import qualified Test.Formats.Reports
import qualified Test.Formats.Values
import qualified Test.Hostile
import qualified Test.House
import Test.Hspec (Spec, describe, parallel)
import Test.Hspec.Runner (Config (..), defaultConfig, hspecWith)
import qualified Test.Proofs.Sources
import qualified Test.Proofs.Subject
import qualified Test.Proofs.ThreeCheckers
import qualified Test.Readme
import qualified Test.Recognition.AnswersBesideTruth
import qualified Test.Recognition.AnyAngle
import qualified Test.Recognition.AnyArray
import qualified Test.Recognition.DamagedOnPurpose
import qualified Test.Recognition.EveryAlphabet
import qualified Test.Recognition.ExplorationsAndTrials
import qualified Test.Recognition.FromBytesToAnswers
import qualified Test.Recognition.FromImageToFace
import qualified Test.Recognition.GridsAndRefusals
import qualified Test.Recognition.Object.EmbossedByCounting
import qualified Test.Recognition.Object.FacesOnTheArray
import qualified Test.Recognition.Object.PlacementsOfAnyFaces
import qualified Test.Recognition.Object.PlatesByDefinition
import qualified Test.Recognition.Object.RoundedSurfaces
import qualified Test.Recognition.Object.SolidsAreClosed
import qualified Test.Recognition.PosesByConstruction
import qualified Test.Recognition.PosteriorByBruteForce
import qualified Test.Recognition.SkewAndWords
import qualified Test.Recognition.SupportByConstruction
import qualified Test.Recognition.SymbolsRead
import qualified Test.Recognition.TakenOtherwise
import qualified Test.Recognition.WhereItIsPressed
import qualified Test.Recognition.WindowsByDefinition
import qualified Test.Schemas
import qualified Test.Simulation.RatesBesideExact
import qualified Test.Simulation.RatesOfAnswers
import qualified Test.Solid.CellsOfFaces
import qualified Test.Solid.FilesOfSolids
import qualified Test.Solid.MergedAndSettled
import qualified Test.Solid.NetsOfSolids
import qualified Test.Solid.PackedByDefinition
import qualified Test.Solid.RegionsTriangulated
import qualified Test.Solid.ReportByDefinition
import qualified Test.Solid.SeenByRays
import qualified Test.Solid.SumsOfRoots
import qualified Test.Solid.UnfoldedByDefinition
import qualified Test.Store.Answers
import qualified Test.Store.Changes
import qualified Test.Store.DrawnPlacements
import qualified Test.Store.Homes
import qualified Test.Store.OnServer
import qualified Test.Store.RowsAndGuards
import qualified Test.Store.Target
import qualified Test.Tools
import qualified Test.Touch.Classification.DescentByRule
import qualified Test.Touch.Classification.EstimatesByPosterior
import qualified Test.Touch.Classification.FirstWeightsByFormula
import qualified Test.Touch.Classification.GradientByDifferences
import qualified Test.Touch.Classification.NetworksAndVerdicts
import qualified Test.Touch.Classification.OtherShapes
import qualified Test.Touch.Classification.PaperExperiment
import qualified Test.Touch.Classification.SpecimensOfEachKind
import qualified Test.Touch.Composite.BlendByDefinition
import qualified Test.Touch.Composite.SkewByDefinition
import qualified Test.Touch.Image.FilesOfOthers
import qualified Test.Touch.Image.PgmByTheManual
import qualified Test.Touch.Image.PgmLaws
import qualified Test.Touch.Image.RastersAndCorrelation
import qualified Test.Touch.Registration.AngleByDefinition
import qualified Test.Touch.Registration.AnswersOfPairs
import qualified Test.Touch.Registration.ByDefinition
import qualified Test.Touch.Registration.CosinesByDefinition
import qualified Test.Touch.Registration.GrownAndSwept
import qualified Test.Touch.Registration.HypothesesAndNoise
import qualified Test.Touch.Registration.JointByFormulas
import qualified Test.Touch.Registration.LatticeAtAnyAngle
import qualified Test.Touch.Registration.OtherLayouts
import qualified Test.Touch.Registration.PairsByFormulas
import qualified Test.Touch.Registration.PairsInParts
import qualified Test.Touch.Registration.PairsRefused
import qualified Test.Touch.Registration.PairsTogether
import qualified Test.Touch.Registration.ResidualAndGroups
import qualified Test.Touch.Registration.ScenesOfKnownTruth
import qualified Test.Touch.Registration.SearchByDefinition
import qualified Test.Touch.Registration.TiltedPresses
import qualified Test.Touch.Registration.WhichMethod
import qualified Test.Touch.Segmentation.BoxesAndAxes
import qualified Test.Touch.Segmentation.ClustersOfNeighbours
import qualified Test.Touch.Segmentation.FeltFarApart
import qualified Test.Touch.Segmentation.ForeignThingsFound
import qualified Test.Touch.Segmentation.PartsByDefinition
import qualified Test.Touch.Segmentation.ScenesAtAnyAngle
import qualified Test.Touch.Segmentation.SymbolsWhereDrawn
import qualified Test.Touch.Sensor.BentFaces
import qualified Test.Touch.Sensor.CalibrationUndoesGains
import qualified Test.Touch.Sensor.ConstantsByClosedForm
import qualified Test.Touch.Sensor.ManifestAgainstGrammar
import qualified Test.Touch.Sensor.MeanHeights
import qualified Test.Touch.Sensor.MotionsAndPlans
import qualified Test.Touch.Sensor.PressesByClosedForm
import qualified Test.Touch.Shape.CheckedDrawings
import qualified Test.Touch.Shape.DesignAndDistance
import qualified Test.Touch.Shape.OutlinesByDefinition

-- | The random cases of a quick run come from one seed, so that a commit always passes or always
-- fails. A full run draws a seed of its own and prints it; @--seed@ replays it.
main :: IO ()
main = do
  -- Each test is shown when it ends, also in a pipe or a file.
  hSetBuffering stdout LineBuffering
  -- Commands run in this process: a pipe that nobody reads is an error of writing to it.
  _ <- installHandler sigPIPE Ignore Nothing
  hspecWith
    defaultConfig
      { configConcurrentJobs = Just 3,
        configQuickCheckSeed = byEffort (Just 20041) Nothing
      }
    specs

-- | All specs. Commands that run in this process have its standard streams one after the other, and
-- meanwhile the rest runs in parallel. Those that bound time or memory are the last, alone.
specs :: Spec
specs = do
  commands
  parallel together
  describe "Conformance: what processes write" Test.Conformance.Process.Output.aloneSpec
  describe "Hostile inputs" Test.Hostile.spec

together :: Spec
together = do
  describe "The house" Test.House.spec
  describe "The code" $ do
    describe "Fields" Test.Code.Field.TablesAndElements.spec
    describe "The structure of fields" Test.Code.Field.StructureByDefinition.spec
    describe "Factorisation" Test.Code.Factorisation.FactorsAndPrimes.spec
    describe "Linear codes" Test.Code.LinearCode.AllCodewords.spec
    describe "Polynomials" Test.Code.Polynomial.RingAndOrders.spec
    describe "Searching polynomials" Test.Code.Polynomial.OrderAndCount.spec
    describe "Extension fields" Test.Code.Field.ExtensionModuloH.spec
    describe "Facts about fields" Test.Code.Field.FactsFromElsewhere.spec
    describe "Sequences as another program has them" Test.Code.Sequence.FactsFromElsewhere.spec
    describe "Shift registers" Test.Code.Sequence.ShiftRegisters.spec
    describe "Fast forms of sequences" Test.Code.Sequence.FastFormsAsDefined.spec
    describe "Arrays" Test.Code.Array.CellsOfTheFold.spec
    describe "Foldings" Test.Code.Array.FoldingsByWalking.spec
    describe "Array codes" Test.Code.Array.SharedWindows.spec
    describe "Advice" Test.Code.Array.AdviceByVisiting.spec
    describe "Windows" Test.Code.Window.MasksAndPacking.spec
    describe "Proofs" Test.Code.Window.ProvedTwice.spec
    describe "Distances" Test.Code.Window.DistanceByPairs.spec
    describe "Certificates" Test.Code.Certificate.IssuedAndChecked.spec
    describe "Certificates step by step" Test.Code.Certificate.EachFlawFound.spec
    describe "Forged certificates" Test.Code.Certificate.ForgeriesRefused.spec
    describe "Census" Test.Code.Census.AllArraysOfASize.spec
    describe "Exhaustive proofs" Test.Code.Window.ProvedExhaustively.spec
    describe "The memory table" Test.Code.Locate.MemoryTable.spec
    describe
      "Locating with errors and erasures on large arrays"
      Test.Code.Locate.ByInformationSets.spec
    describe "Chance" Test.Code.Locate.ChanceByEnumeration.spec
    describe "Locating: which decoder" Test.Code.Locate.WhichDecoder.spec
    describe "Locating from probabilities" Test.Code.Locate.ProbabilitiesByBayes.spec
    describe "Probabilities far below rounding" Test.Code.Locate.FarBelowDoubles.spec
    describe "Unknown orientation" Test.Code.Locate.UnknownOrientation.spec
    describe "Every decoder is the definition" Test.Code.Locate.EveryDecoderAsDefined.spec
    describe "Parity checks among cells" Test.Code.Locate.ParityChecks.spec
    describe "Several patches" Test.Code.Locate.SeveralPatches.spec
    describe "Foreign patches" $ do
      Test.Code.Locate.ForeignPatches.spec
      Test.Code.Locate.ForeignMixture.spec
    describe "Rates of answers" Test.Simulation.RatesOfAnswers.spec
    describe "Profiles" Test.Code.Profile.DoorToArrays.spec
  describe "Touch" $ do
    describe "Images" Test.Touch.Image.RastersAndCorrelation.spec
    describe "PGM" Test.Touch.Image.PgmLaws.spec
    describe "Files of other programs" Test.Touch.Image.FilesOfOthers.spec
    describe "PGM by the manual's examples" Test.Touch.Image.PgmByTheManual.spec
    describe "Probing" Test.Touch.Sensor.MotionsAndPlans.spec
    describe "Manifests word by word" Test.Touch.Sensor.ManifestAgainstGrammar.spec
    describe "The sensor" Test.Touch.Sensor.MeanHeights.spec
    describe "The sensor on bent faces" Test.Touch.Sensor.BentFaces.spec
    describe "The sensor's constants" Test.Touch.Sensor.ConstantsByClosedForm.spec
    describe "The sensor as a whole" Test.Touch.Sensor.PressesByClosedForm.spec
    describe "Calibration and other sensors" Test.Touch.Sensor.CalibrationUndoesGains.spec
    describe "Stitching" $ do
      Test.Touch.Registration.ScenesOfKnownTruth.spec
      Test.Touch.Registration.LatticeAtAnyAngle.spec
    describe "Cosine transforms" Test.Touch.Registration.CosinesByDefinition.spec
    describe "What stitching is made of" Test.Touch.Registration.HypothesesAndNoise.spec
    describe "The search for a frame" Test.Touch.Registration.SearchByDefinition.spec
    describe "Tilted presses" Test.Touch.Registration.TiltedPresses.spec
    describe "What registration of pairs is made of" Test.Touch.Registration.PairsInParts.spec
    describe "Frames put together by all their pairs" Test.Touch.Registration.PairsTogether.spec
    describe "What is told of frames put together" Test.Touch.Registration.ResidualAndGroups.spec
    describe "Registration by its formulas" Test.Touch.Registration.ByDefinition.spec
    describe
      "The angle of a lattice, by what frames tell"
      Test.Touch.Registration.AngleByDefinition.spec
    describe "Registration one frame after the other" Test.Touch.Registration.GrownAndSwept.spec
    describe "What joint registration is made of" Test.Touch.Registration.JointByFormulas.spec
    describe "Layouts other than the robot tells" Test.Touch.Registration.OtherLayouts.spec
    describe "The methods of registering frames" Test.Touch.Registration.WhichMethod.spec
    describe "Registration of pairs by its formulas" Test.Touch.Registration.PairsByFormulas.spec
    describe "Registration of pairs" Test.Touch.Registration.PairsRefused.spec
    describe "Registration of pairs as a whole" Test.Touch.Registration.AnswersOfPairs.spec
    describe "Blending and growing" Test.Touch.Composite.BlendByDefinition.spec
    describe "Segmentation" Test.Touch.Segmentation.SymbolsWhereDrawn.spec
    describe "Symbols in clusters" Test.Touch.Segmentation.ClustersOfNeighbours.spec
    describe "Segmentation: foreign regions" Test.Touch.Segmentation.ForeignThingsFound.spec
    describe "Segmentation of what was felt far apart" Test.Touch.Segmentation.FeltFarApart.spec
    describe "What segmentation is made of" Test.Touch.Segmentation.PartsByDefinition.spec
    describe "Segmentation of scenes" Test.Touch.Segmentation.ScenesAtAnyAngle.spec
    describe "The angle of a composite" Test.Touch.Composite.SkewByDefinition.spec
    describe "Extents" Test.Touch.Segmentation.BoxesAndAxes.spec
    describe "Shapes" Test.Touch.Shape.DesignAndDistance.spec
    describe "Drawings checked" Test.Touch.Shape.CheckedDrawings.spec
    describe "Outlines" Test.Touch.Shape.OutlinesByDefinition.spec
    describe "What recognising is made of" Test.Touch.Classification.EstimatesByPosterior.spec
    describe "The network" Test.Touch.Classification.NetworksAndVerdicts.spec
    describe "Training" Test.Touch.Classification.GradientByDifferences.spec
    describe "Training step by step" Test.Touch.Classification.DescentByRule.spec
    describe "Other shapes" Test.Touch.Classification.OtherShapes.spec
    describe "First weights" Test.Touch.Classification.FirstWeightsByFormula.spec
    describe "The paper's experiment" Test.Touch.Classification.PaperExperiment.spec
    describe "Training images and parts" Test.Touch.Classification.SpecimensOfEachKind.spec
  describe "Objects" $ do
    describe "Winged edges" Test.Recognition.Object.SolidsAreClosed.spec
    describe "Solids by definition" Test.Solid.ReportByDefinition.spec
    describe "Solids seen, by rays" Test.Solid.SeenByRays.spec
    describe "Cells of faces" Test.Solid.CellsOfFaces.spec
    describe "Merged and settled" Test.Solid.MergedAndSettled.spec
    describe "Sums of roots" Test.Solid.SumsOfRoots.spec
    describe "Nets of solids" Test.Solid.NetsOfSolids.spec
    describe "Nets by definition" Test.Solid.UnfoldedByDefinition.spec
    describe "Packing" Test.Solid.PackedByDefinition.spec
    describe "Files of solids" Test.Solid.FilesOfSolids.spec
    describe "Placement" Test.Recognition.Object.FacesOnTheArray.spec
    describe "Placement of any faces" Test.Recognition.Object.PlacementsOfAnyFaces.spec
    describe "Regions triangulated" Test.Solid.RegionsTriangulated.spec
    describe "Embossing" Test.Recognition.Object.EmbossedByCounting.spec
    describe "Plates by definition" Test.Recognition.Object.PlatesByDefinition.spec
    describe "Surfaces as files hold them" Test.Recognition.Object.RoundedSurfaces.spec
  describe "Store" . Test.Store.Homes.inEachHome $ do
    Test.Store.Answers.spec
    Test.Store.DrawnPlacements.spec
    Test.Store.Changes.spec
  describe "Store" Test.Store.OnServer.spec
  describe "Store" Test.Store.Changes.inFiles
  describe "Store" Test.Store.RowsAndGuards.spec
  describe "Store" Test.Store.Target.spec
  describe "Decimal numbers" Test.Common.DecimalsByDefinition.spec
  describe "Plain texts" Test.Common.PlainTexts.spec
  describe "Symmetry" Test.Common.SymmetryGroup.spec
  describe "Rates" Test.Simulation.RatesBesideExact.spec
  describe "Recognition" Test.Recognition.FromImageToFace.spec
  describe "Recognition at any angle" Test.Recognition.AnyAngle.spec
  describe "Recognition of any array" Test.Recognition.AnyArray.spec
  describe "Recognition with every alphabet" Test.Recognition.EveryAlphabet.spec
  describe "Recognition with damage" Test.Recognition.DamagedOnPurpose.spec
  describe "Recognition: grids, room and words" Test.Recognition.GridsAndRefusals.spec
  describe "Recognition: what is read" Test.Recognition.SymbolsRead.spec
  describe "Recognition: taken otherwise" Test.Recognition.TakenOtherwise.spec
  describe "Recognition step by step" Test.Recognition.SkewAndWords.spec
  describe "Recognition: what is found" Test.Recognition.WindowsByDefinition.spec
  describe "Poses" Test.Recognition.PosesByConstruction.spec
  describe "Recognition by Bayes' theorem" Test.Recognition.PosteriorByBruteForce.spec
  describe "Recognition of grids built by hand" Test.Recognition.SupportByConstruction.spec
  describe "Explorations and trials" Test.Recognition.ExplorationsAndTrials.spec
  describe "Where it is pressed" Test.Recognition.WhereItIsPressed.spec
  describe "Truths" Test.Recognition.AnswersBesideTruth.spec
  describe "Formats" Test.Formats.spec
  describe "Formats: keys given twice" Test.Formats.Json.spec
  describe "Formats: rates" Test.Formats.Rates.spec
  describe "Formats: registrations" Test.Formats.Registration.spec
  describe "Formats: reports of answers" Test.Formats.Reports.spec
  describe "Formats: values" Test.Formats.Values.spec
  describe "Formats: networks" Test.Formats.Networks.spec
  describe "Formats: census files" Test.Formats.CensusFile.spec
  describe "Formats: files of evaluations' shards" Test.Formats.EvaluationFile.spec
  describe "Pictures" Test.App.RecognitionsDrawn.spec
  describe "Pictures of assemblies" Test.App.AssembliesDrawn.spec
  describe "Sources" Test.Recognition.FromBytesToAnswers.spec
  describe "README" Test.Readme.spec
  describe "Conformance laws on this library" Test.Conformance.Laws.spec
  describe "Conformance laws on the definitions in Coq" Test.Proofs.Subject.spec
  describe "Proofs: three checkers of certificates" Test.Proofs.ThreeCheckers.spec
  describe "Proofs: their sources" Test.Proofs.Sources.spec
  describe "Conformance: the definition" Test.Conformance.Definition.spec
  describe "Conformance: what fails" Test.Conformance.Properties.spec
  describe "Conformance: profiles in force" Test.Conformance.InProcess.spec
  describe "Conformance: lines" Test.Conformance.Wire.Lines.spec
  describe "Conformance: operations" Test.Conformance.Operations.spec
  describe "Conformance: reports" Test.Conformance.Report.spec
  describe "Conformance: the runner" Test.Conformance.Run.Search.spec
  describe "Conformance: what the runner tries" Test.Conformance.Run.Choice.spec
  describe "Conformance: the version of the suite" Test.Conformance.Versions.spec
  describe "Conformance: what the runner reports" Test.Conformance.Run.Counterexamples.spec
  describe "Conformance: whole runs" Test.Conformance.Run.Whole.spec
  describe "Conformance: what processes write" Test.Conformance.Process.Output.spec
  describe "Conformance: what must hold of processes" Test.Conformance.Process.Checks.spec
  describe "Conformance: processes" Test.Conformance.Process.Faults.spec
  describe "Conformance: the server" Test.Conformance.Serve.spec
  describe "What is said is what happens" Test.Documents.spec
  describe "Schemas" Test.Schemas.spec
  describe "The examples" Test.Examples.spec

-- | Most commands run in this process.
commands :: Spec
commands = do
  describe "Conformance: processes" Test.Conformance.Process.Faults.usageSpec
  describe "Conformance: test vectors" Test.Conformance.Vectors.spec
  describe "The command line" Test.CommandLine.spec
  describe "The command line: output, arguments, names" Test.CommandLine.Output.spec
  describe "The command line: what answers are worth" Test.CommandLine.Chance.spec
  describe "The command line: decoding" Test.CommandLine.Decode.spec
  describe "The command line: frames in other forms" Test.CommandLine.Images.spec
  describe "The command line: embossing" Test.CommandLine.Emboss.spec
  describe "The command line: pictures and truths" Test.CommandLine.Picture.spec
  describe "The command line: locating" Test.CommandLine.Locate.spec
  describe "The command line: large patches" Test.CommandLine.Patches.spec
  describe "The command line: long work" Test.CommandLine.LongWork.spec
  describe "The command line: nets" Test.CommandLine.Nets.spec
  describe "The command line: fields and polynomials" Test.CommandLine.Fields.spec
  describe "The command line: sensors" Test.CommandLine.Sensor.spec
  describe "The command line: shapes" Test.CommandLine.Shapes.spec
  describe "The command line: networks" Test.CommandLine.Networks.spec
  describe "The command line: sequences and foldings" Test.CommandLine.Sequences.spec
  describe "The command line: faces of files on the array" Test.CommandLine.Place.spec
  describe "The command line: solids in words and in JSON" Test.CommandLine.SolidsInWords.spec
  describe "The command line: the smallest array" Test.CommandLine.Smallest.spec
  describe "The command line: rates" Test.CommandLine.Rates.spec
  describe "The command line: poses" Test.CommandLine.Pose.spec
  describe "The command line: proofs and certificates" Test.CommandLine.Proof.spec
  describe "The command line: census" Test.CommandLine.Census.spec
  describe "The command line: shards of evaluations" Test.CommandLine.Shards.spec
  describe "The tools" Test.Tools.spec
  describe "The command line: JSON" Test.CommandLine.Json.spec
  describe "The command line: advice" Test.CommandLine.Advice.spec
  describe "The command line: bounds" Test.CommandLine.Bounds.spec
